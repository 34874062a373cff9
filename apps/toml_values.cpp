#include "apps/toml_values.h"

#include <cmath>
#include <sstream>

#include "apps/words.h"

namespace ease {

namespace {

/// Formats a number with the fewest digits that identify it, and with a point or an exponent to show it is no integer.
std::string fractionText(double value) {
  const std::string text = fmt::format("{}", value);
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

bool inRange(double x, const Range& range) {
  return std::isfinite(x) && (range.above_low ? x > range.low : x >= range.low) && x <= range.high;
}

}  // namespace

std::string valueText(const toml::node& node) {
  constexpr size_t kLongest = 60;
  std::string text;
  if (const auto* fraction = node.as_floating_point()) {
    text = fractionText(fraction->get());
  } else if (const auto* array = node.as_array()) {
    for (const toml::node& entry : *array) text += (text.empty() ? "" : ", ") + valueText(entry);
    text = "[" + text + "]";
  } else {
    std::ostringstream out;
    node.visit([&](const auto& value) { out << value; });
    text = oneLine(out.str());
  }
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + " ...";
}

std::string typeText(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number with a fraction";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

std::string rangeText(const Range& range) {
  const std::string unit = *range.unit ? std::string(" ") + range.unit : "";
  return range.above_low ? fmt::format("a number above {:g} and at most {:g}{}", range.low, range.high, unit)
                         : fmt::format("a number from {:g} to {:g}{}", range.low, range.high, unit);
}

std::string integerText(int low, int high) {
  return fmt::format("a whole number from {} to {}", low, high);
}

std::optional<int> integerIn(const toml::node& node, int low, int high) {
  const auto value = node.value_exact<int64_t>();
  if (!value || *value < low || *value > high) return std::nullopt;
  return static_cast<int>(*value);
}

std::optional<double> numberIn(const toml::node& node, const Range& range) {
  if (!node.is_number()) return std::nullopt;
  const double value = *node.value<double>();
  return inRange(value, range) ? std::optional(value) : std::nullopt;
}

}  // namespace ease
