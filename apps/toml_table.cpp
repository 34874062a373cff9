#include "apps/toml_table.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "apps/toml_values.h"
#include "apps/words.h"
#include "solver/base/error.h"

namespace ease {

struct TomlTable::Data {
  std::shared_ptr<const toml::table> root;  // keeps `table` alive
  const toml::table* table;
  std::string file;
  std::string path;  // "", "garment", "garment.pin"
  bool of_array;     // whether it is an entry of [[path]]

  std::string label() const {
    if (path.empty()) return "";
    return of_array ? "[[" + path + "]] " : "[" + path + "] ";
  }
  std::string pathOf(std::string_view key) const {
    return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
  }
  std::string place(const toml::node& node) const {
    const auto line = node.source().begin.line;
    return line > 0 ? fmt::format("{}:{}: ", file, line) : file + ": ";
  }
};

TomlTable::TomlTable(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

TomlTable TomlTable::read(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) throw InputError(fmt::format("{}: no such scene file", file.string()));
  if (std::filesystem::file_size(file, ignored) == 0)
    throw InputError(fmt::format("{}: is empty: expected a scene, with a table [garment]", file.string()));
  std::ifstream in(file, std::ios::binary);
  std::ostringstream content;
  if (std::filesystem::is_directory(file, ignored) || !in || !(content << in.rdbuf()))
    throw InputError(fmt::format("{}: cannot be read as a scene file", file.string()));
  return parse(content.str(), file);
}

TomlTable TomlTable::parse(const std::string& text, const std::filesystem::path& file) {
  try {
    auto root = std::make_shared<const toml::table>(toml::parse(text, file.string()));
    return TomlTable(std::make_shared<const Data>(Data{root, root.get(), file.string(), "", false}));
  } catch (const toml::parse_error& error) {
    const auto line = error.source().begin.line;
    throw InputError(fmt::format("{}:{}: not TOML: {}", file.string(), line, oneLine(error.description())));
  }
}

void TomlTable::allow(const std::vector<std::string_view>& keys) const {
  const toml::node* first = nullptr;
  std::string_view unknown;
  for (const auto& [key, node] : *data_->table) {
    const bool known = std::find(keys.begin(), keys.end(), key.str()) != keys.end();
    if (known || (first && first->source().begin.line <= node.source().begin.line)) continue;
    first = &node;
    unknown = key.str();
  }
  if (!first) return;

  throw InputError(fmt::format("{}{}'{}' is not a known {}; {}", data_->place(*first), data_->label(), unknown,
                               first->is_table() || first->is_array_of_tables() ? "table" : "key",
                               adviceFor(unknown, {keys.begin(), keys.end()}, "known here:")));
}

std::string TomlTable::written(std::initializer_list<std::string_view> without) const {
  toml::table table = *data_->table;
  for (const std::string_view key : without) table.erase(key);
  std::ostringstream out;
  out << table;
  return out.str();
}

bool TomlTable::has(std::string_view key) const {
  return data_->table->contains(key);
}

bool TomlTable::isArray(std::string_view key) const {
  return has(key) && data_->table->get(key)->is_array();
}

bool TomlTable::isText(std::string_view key) const {
  return has(key) && data_->table->get(key)->is_string();
}

bool TomlTable::isTable(std::string_view key) const {
  return has(key) && data_->table->get(key)->is_table();
}

bool TomlTable::isBoolean(std::string_view key) const {
  return has(key) && data_->table->get(key)->is_boolean();
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, node] : *data_->table) keys.emplace_back(key.str());
  return keys;
}

std::optional<TomlTable> TomlTable::table(std::string_view key) const {
  const toml::node* node = data_->table->get(key);
  if (!node) return std::nullopt;
  if (!node->is_table()) refuse(key, fmt::format("a table [{}], found {}", data_->pathOf(key), typeText(*node)));
  return TomlTable(
      std::make_shared<const Data>(Data{data_->root, node->as_table(), data_->file, data_->pathOf(key), false}));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  const toml::node* node = data_->table->get(key);
  if (!node) return {};
  if (!node->is_array_of_tables())
    refuse(key, fmt::format("tables [[{}]], in double brackets, found {}", data_->pathOf(key), typeText(*node)));
  std::vector<TomlTable> found;
  for (const toml::node& entry : *node->as_array())
    found.push_back(TomlTable(
        std::make_shared<const Data>(Data{data_->root, entry.as_table(), data_->file, data_->pathOf(key), true})));
  return found;
}

double TomlTable::number(std::string_view key, double fallback, const Range& range) const {
  const toml::node* node = data_->table->get(key);
  if (!node) return fallback;
  const auto value = numberIn(*node, range);
  if (!value) refuse(key, rangeText(range) + (node->is_number() ? "" : ", found " + typeText(*node)));
  return *value;
}

int TomlTable::integer(std::string_view key, int fallback, int low, int high) const {
  const toml::node* node = data_->table->get(key);
  if (!node) return fallback;
  const auto value = integerIn(*node, low, high);
  if (!value) refuse(key, integerText(low, high) + (node->is_integer() ? "" : ", found " + typeText(*node)));
  return *value;
}

bool TomlTable::boolean(std::string_view key, bool fallback) const {
  const toml::node* node = data_->table->get(key);
  if (!node) return fallback;
  if (!node->is_boolean()) refuse(key, "true or false, found " + typeText(*node));
  return *node->value<bool>();
}

std::string TomlTable::text(std::string_view key, const std::string& fallback) const {
  const toml::node* node = data_->table->get(key);
  if (!node) return fallback;
  if (!node->is_string()) refuse(key, "a string, found " + typeText(*node));
  const std::string value = *node->value<std::string>();
  if (value.empty()) refuse(key, "a string that is not empty");
  return value;
}

std::string TomlTable::choice(std::string_view key, const std::string& fallback,
                              const std::vector<std::string>& words) const {
  if (!has(key)) return fallback;
  const toml::node* node = data_->table->get(key);
  if (!node->is_string()) refuse(key, listWords(words) + ", found " + typeText(*node));
  const std::string value = *node->value<std::string>();
  if (std::find(words.begin(), words.end(), value) == words.end()) refuse(key, listWords(words));
  return value;
}

std::vector<double> TomlTable::numbers(std::string_view key, const Range& range) const {
  if (!has(key)) return {};
  std::string fault;
  auto values = readArray<double>(
      *data_->table->get(key), [&](const toml::node& entry) { return numberIn(entry, range); }, fault);
  if (!fault.empty()) refuse(key, fmt::format("an array whose entries are {}; {}", rangeText(range), fault));
  return values;
}

std::vector<std::vector<double>> TomlTable::rows(std::string_view key, const Range& range, size_t length) const {
  if (!has(key)) return {};
  std::string fault;
  const auto read = [&](const toml::node& entry) -> std::optional<std::vector<double>> {
    std::string row_fault;
    auto row = readArray<double>(
        entry, [&](const toml::node& number) { return numberIn(number, range); }, row_fault);
    return row_fault.empty() && row.size() == length ? std::optional(std::move(row)) : std::nullopt;
  };
  auto values = readArray<std::vector<double>>(*data_->table->get(key), read, fault);
  if (!fault.empty())
    refuse(key, fmt::format("an array of arrays of {} numbers, each {}; {}", length, rangeText(range), fault));
  return values;
}

std::vector<int> TomlTable::integers(std::string_view key, int low, int high) const {
  if (!has(key)) return {};
  std::string fault;
  auto values = readArray<int>(
      *data_->table->get(key), [&](const toml::node& entry) { return integerIn(entry, low, high); }, fault);
  if (!fault.empty()) refuse(key, fmt::format("an array whose entries are {}; {}", integerText(low, high), fault));
  return values;
}

std::vector<std::string> TomlTable::texts(std::string_view key) const {
  if (!has(key)) return {};
  std::string fault;
  const auto read = [](const toml::node& entry) {
    auto value = entry.value_exact<std::string>();
    return value && !value->empty() ? value : std::nullopt;
  };
  auto values = readArray<std::string>(*data_->table->get(key), read, fault);
  if (!fault.empty()) refuse(key, "an array of strings; " + fault);
  return values;
}

void TomlTable::refuse(std::string_view key, const std::string& expected) const {
  const toml::node* node = data_->table->get(key);
  if (!node)
    throw InputError(
        fmt::format("{}{}{} is missing: expected {}", data_->place(*data_->table), data_->label(), key, expected));
  const std::string value = node->is_table() || node->is_array_of_tables() ? "" : " = " + valueText(*node);
  throw InputError(fmt::format("{}{}{}{}: expected {}", data_->place(*node), data_->label(), key, value, expected));
}

}  // namespace ease
