#include "apps/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace ease {

namespace {

/// Returns the restricted Damerau-Levenshtein distance between two words: the number of edits that turn one into the
/// other.  distance[i][j] is that of the first i letters of `a` from the first j of `b`.
size_t keystrokesBetween(std::string_view a, std::string_view b) {
  std::vector<std::vector<size_t>> distance(a.size() + 1, std::vector<size_t>(b.size() + 1));
  for (size_t i = 0; i <= a.size(); ++i) distance[i][0] = i;
  for (size_t j = 0; j <= b.size(); ++j) distance[0][j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t other = distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      distance[i][j] = std::min({other, distance[i - 1][j] + 1, distance[i][j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
    }
  }
  return distance[a.size()][b.size()];
}

}  // namespace

std::string counted(long count, const std::string& what) {
  const std::string plural = what == "vertex" ? "vertices" : what + "s";
  return fmt::format("{} {}", count, count == 1 ? what : plural);
}

std::string listWords(const std::vector<std::string>& words) {
  std::string list;
  for (size_t i = 0; i < words.size(); ++i) {
    if (i > 0) list += i + 1 < words.size() ? ", " : " or ";
    list += "'" + words[i] + "'";
  }
  return list;
}

std::string adviceFor(std::string_view word, const std::vector<std::string>& words, std::string_view known) {
  const std::string nearest = nearestWord(word, words);
  return nearest.empty() ? fmt::format("{} {}", known, listWords(words)) : fmt::format("did you mean '{}'?", nearest);
}

std::string oneLine(std::string_view text) {
  std::string line;
  for (const unsigned char c : text) line += c < ' ' || c == 127 ? ' ' : static_cast<char>(c);
  return line;
}

std::string nearestWord(std::string_view word, const std::vector<std::string>& words) {
  std::string nearest;
  size_t least = std::max<size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : words) {
    const size_t distance = keystrokesBetween(word, candidate);
    if (distance >= least || distance >= candidate.size()) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

}  // namespace ease
