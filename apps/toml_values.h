// Values of TOML: what they are in words, and as numbers within a range.
#pragma once

#include <fmt/format.h>
#include <toml++/toml.h>

#include <optional>
#include <string>
#include <vector>

#include "apps/toml_table.h"

namespace ease {

/// Formats a value as TOML on one line, shortened if it is long.
std::string valueText(const toml::node& node);

/// The type of a value with its article, such as "a whole number".
std::string typeText(const toml::node& node);

/// What is expected, such as "a number from 0 to 1 m".
std::string rangeText(const Range& range);
std::string integerText(int low, int high);

/// The number, or nothing where the value is of another type or out of range.
std::optional<int> integerIn(const toml::node& node, int low, int high);
std::optional<double> numberIn(const toml::node& node, const Range& range);

/// Reads the entries of an array by `read`; if that fails, sets `fault` to what was found instead.
template <class Value, class Read>
std::vector<Value> readArray(const toml::node& node, const Read& read, std::string& fault) {
  const toml::array* array = node.as_array();
  if (!array) {
    fault = "found " + typeText(node);
    return {};
  }
  if (array->empty()) fault = "found none";
  std::vector<Value> values;
  for (const toml::node& entry : *array) {
    const std::optional<Value> value = read(entry);
    if (!value) {
      fault = fmt::format("entry {} is {}", values.size() + 1, valueText(entry));
      return {};
    }
    values.push_back(*value);
  }
  return values;
}

}  // namespace ease
