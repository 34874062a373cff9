// A table of a TOML file, read with checks: whatever is wrong becomes one line for the user,
//
//   FILE:LINE: [table] key = value: expected ...
//
// The TOML library is seen by the source file only.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ease {

/// The numbers that make sense for a key, in its unit: low <= x <= high, or low < x <= high.
struct Range {
  double low;
  double high;
  bool above_low = false;  // low itself is left out
  const char* unit = "";
};

class TomlTable {
 public:
  /// The file's root table.  Throws InputError if the file is missing or is not TOML.
  static TomlTable read(const std::filesystem::path& file);

  /// Refuses every key but these, naming the nearest of them.  Call it first: a misspelt key explains a missing one.
  void allow(std::initializer_list<std::string_view> keys) const;

  bool has(std::string_view key) const;

  /// [key]; nothing if absent.
  std::optional<TomlTable> table(std::string_view key) const;
  /// [[key]], in the file's order; empty if absent.
  std::vector<TomlTable> tables(std::string_view key) const;

  // Values of keys, `fallback` where absent.  Refused, as by refuse(): another type, a number out of range or not
  // finite.
  double number(std::string_view key, double fallback, const Range& range) const;
  int integer(std::string_view key, int fallback, int low, int high) const;
  bool boolean(std::string_view key, bool fallback) const;
  std::string text(std::string_view key, const std::string& fallback) const;
  std::string choice(std::string_view key, const std::string& fallback, const std::vector<std::string>& words) const;

  // Arrays, empty where absent.  A single value is no array, and an array that is there has at least one entry.  Rows
  // are arrays of `length` numbers.
  std::vector<double> numbers(std::string_view key, const Range& range) const;
  std::vector<std::vector<double>> rows(std::string_view key, const Range& range, size_t length) const;
  std::vector<int> integers(std::string_view key, int low, int high) const;
  std::vector<std::string> texts(std::string_view key) const;

  bool isArray(std::string_view key) const;
  bool isText(std::string_view key) const;

  /// Throws InputError: the key's line and value (or that it is missing), and what was expected.
  [[noreturn]] void refuse(std::string_view key, const std::string& expected) const;

 private:
  struct Data;
  explicit TomlTable(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
};

}  // namespace ease
