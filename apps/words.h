// Text for messages: lists of words, and suggestions for misspelt words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ease {

/// Joins the words to a list such as "'a', 'b' or 'c'".
std::string listWords(const std::vector<std::string>& words);

/// "3 open edges", "1 open edge".
std::string counted(long count, const std::string& what);

/// "did you mean 'hem'?" where one of the words is near, otherwise `known` and all of them: "there are 'hem' or
/// 'neck'".
std::string adviceFor(std::string_view word, const std::vector<std::string>& words, std::string_view known);

/// Returns the text with line ends and other control characters replaced by spaces.
std::string oneLine(std::string_view text);

/// Returns the word with the smallest edit distance from `word`, where an edit inserts, deletes or replaces a letter or
/// swaps two neighbours.  Returns an empty string if more edits are needed than two and than a third of `word`'s
/// letters.
std::string nearestWord(std::string_view word, const std::vector<std::string>& words);

}  // namespace ease
