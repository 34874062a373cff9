// Readers that readMesh calls, one per file format, and the functions that they share.
//
// The project reads PLY, OBJ and STL itself and does not use VTK for them: VTK's PLY reader rounds to single precision
// and never returns from a truncated file, its STL reader accepts any bytes as triangles, and its OBJ reader may
// renumber vertices.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ease {

/// Unchecked contents of a mesh file, in the file's order. Coordinates may be NaN, and indices may be out of range.
struct RawMesh {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<long long, 3>> triangles;  // vertex indices from 0

  /// Cuts a polygon of at least three corners into a fan from its first corner. The cut depends only on the numbering,
  /// so that all poses of one body are cut in the same way.
  void addPolygon(std::span<const long long> corners) {
    for (std::size_t k = 2; k < corners.size(); ++k) triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }
};

/// Read the bytes of one file. They throw InputError with a message that begins with `name`.
RawMesh readPly(std::string_view bytes, const std::string& name);
RawMesh readObj(std::string_view bytes, const std::string& name);
RawMesh readStl(std::string_view bytes, const std::string& name);
RawMesh readVtp(std::string_view bytes, const std::string& name);

/// Throws InputError if counts in a .vtp file would make VTK crash or allocate more memory than the file could fill.
void checkVtpCounts(std::string_view bytes, const std::string& name);

/// Removes the first line from `text` and returns it without its line end ("\n" or "\r\n").
inline std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Removes the first word from `text` and returns it, skipping blanks and line ends; returns an empty word at the end.
inline std::string_view takeWord(std::string_view& text) {
  const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f'; };
  std::size_t begin = 0;
  while (begin < text.size() && isBlank(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && !isBlank(text[end])) ++end;
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

/// Parses all of `word` as one number, independently of the locale; returns nothing if that fails.
template <class Number>
std::optional<Number> parseNumber(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace ease
