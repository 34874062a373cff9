// The readers behind readMesh, one per file format, and the functions that they share.
//
// PLY, OBJ and STL are read here, not by VTK: its PLY reader keeps single precision and never returns from a
// truncated file, its STL reader accepts any bytes as triangles, its OBJ reader may renumber vertices.
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

/// A mesh as its file holds it, in the file's order: coordinates may still be NaN and indices out of range.
struct RawMesh {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<long long, 3>> triangles;  // vertex indices from 0

  /// Cuts a polygon of at least three corners into a fan from its first corner: the cut depends on the numbering alone,
  /// so that poses of one body are all cut alike.
  void addPolygon(std::span<const long long> corners) {
    for (std::size_t k = 2; k < corners.size(); ++k) triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }
};

/// Each reads the bytes of one file; `name` stands at the front of every message.  They throw InputError.
RawMesh readPly(std::string_view bytes, const std::string& name);
RawMesh readObj(std::string_view bytes, const std::string& name);
RawMesh readStl(std::string_view bytes, const std::string& name);
RawMesh readVtp(std::string_view bytes, const std::string& name);

/// Throws InputError for a .vtp file whose counts would make VTK crash or allocate memory that the file cannot fill.
void checkVtpCounts(std::string_view bytes, const std::string& name);

/// Removes the first line from `text`, without its line end ("\n" or "\r\n").
inline std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Removes the first word from `text`, skipping line ends; empty at the end.
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

/// Parses all of `word` as one number, independent of the locale; returns none if that fails.
template <class Number>
std::optional<Number> parseNumber(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace ease
