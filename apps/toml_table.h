// A table of a TOML file whose values are checked when they are read.  Every error is one line for the user:
//
//   FILE:LINE: [table] key = value: expected ...
//
// Only the source file includes the TOML library.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ease {

/// Range of the valid values of a key, in its unit: low <= x <= high, or low < x <= high.
struct Range {
  double low;
  double high;
  bool above_low = false;  // whether `low` itself is excluded
  const char* unit = "";
};

class TomlTable {
 public:
  /// Reads the file and returns its root table.  Throws InputError if the file is missing or is not TOML.
  static TomlTable read(const std::filesystem::path& file);
  /// Reads a text; `file` names it in messages and need not exist.
  static TomlTable parse(const std::string& text, const std::filesystem::path& file);

  /// Throws InputError if the table has a key other than these, and suggests the most similar of them.  To be called
  /// before reading: a misspelt key should be reported as such, not as a missing one.
  void allow(const std::vector<std::string_view>& keys) const;

  bool has(std::string_view key) const;

  /// Returns the table [key], or nothing if it is absent.
  std::optional<TomlTable> table(std::string_view key) const;
  /// Returns the array of tables [[key]] in the file's order; empty if it is absent.
  std::vector<TomlTable> tables(std::string_view key) const;

  // Each function returns the value of a key, or `fallback` if the key is absent.  It throws like refuse() if the value
  // has another type, or is a number that is out of range or not finite.
  double number(std::string_view key, double fallback, const Range& range) const;
  int integer(std::string_view key, int fallback, int low, int high) const;
  bool boolean(std::string_view key, bool fallback) const;
  std::string text(std::string_view key, const std::string& fallback) const;
  std::string choice(std::string_view key, const std::string& fallback, const std::vector<std::string>& words) const;

  // Each function returns an array, empty if the key is absent.  It throws like refuse() for a single value and for an
  // array without entries.  Each of the `rows` is an array of `length` numbers.
  std::vector<double> numbers(std::string_view key, const Range& range) const;
  std::vector<std::vector<double>> rows(std::string_view key, const Range& range, size_t length) const;
  std::vector<int> integers(std::string_view key, int low, int high) const;
  std::vector<std::string> texts(std::string_view key) const;

  bool isArray(std::string_view key) const;
  bool isText(std::string_view key) const;
  bool isTable(std::string_view key) const;
  bool isBoolean(std::string_view key) const;

  /// All keys of the table, for one whose keys are names that users choose.
  std::vector<std::string> keys() const;

  /// The table as TOML without comments and without these keys, sorted by key.
  std::string written(std::initializer_list<std::string_view> without) const;

  /// Throws InputError with the key's line and value (or that it is missing) and with what was expected.
  [[noreturn]] void refuse(std::string_view key, const std::string& expected) const;

 private:
  struct Data;
  explicit TomlTable(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
};

}  // namespace ease
