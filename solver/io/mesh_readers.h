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
  std::vector<long long> corners;  // of all polygons, vertex indices from 0
  std::vector<std::size_t> ends;   // place in `corners` behind the last corner of each polygon

  void addPolygon(std::span<const long long> polygon) {
    corners.insert(corners.end(), polygon.begin(), polygon.end());
    ends.push_back(corners.size());
  }

  /// Adds the triangles of a strip: each corner from the third on makes one with the two before it, turned over every
  /// second time. Those that only move the strip on, with a corner twice, are left out.
  void addStrip(std::span<const long long> strip) {
    for (std::size_t k = 2; k < strip.size(); ++k) {
      const long long a = strip[k - 2], b = strip[k - 1], c = strip[k];
      if (a == b || b == c || c == a) continue;
      if (k % 2 == 0) addPolygon(std::array{a, b, c});
      if (k % 2 == 1) addPolygon(std::array{b, a, c});
    }
  }
};

/// Read the bytes of one file. They throw InputError with a message that begins with `name`.
RawMesh readPly(std::string_view bytes, const std::string& name);
RawMesh readObj(std::string_view bytes, const std::string& name);
RawMesh readStl(std::string_view bytes, const std::string& name);  // three vertices a triangle, none shared
RawMesh readOff(std::string_view bytes, const std::string& name);
RawMesh readVtp(std::string_view bytes, const std::string& name);

/// Throws InputError if counts in a .vtp file would make VTK crash or allocate more memory than the file could fill.
void checkVtpCounts(std::string_view bytes, const std::string& name);

/// Removes the first line from `text` and returns it without its line end ("\n", "\r\n" or "\r").
inline std::string_view takeLine(std::string_view& text) {
  std::size_t end = std::min(text.find('\n'), text.size());
  end = std::min(text.substr(0, end).find('\r'), end);
  const std::string_view line = text.substr(0, end);
  const std::size_t wide = text.substr(end).starts_with("\r\n") ? 2 : 1;
  text.remove_prefix(std::min(end + wide, text.size()));
  return line;
}

/// Whether two words are the same but for capitals; `lower` has none.
inline bool isWord(std::string_view word, std::string_view lower) {
  const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b; };
  return word.size() == lower.size() && std::equal(word.begin(), word.end(), lower.begin(), same);
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
