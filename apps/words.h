// Words for messages: lists, and the word that was probably meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ease {

/// "'a', 'b' or 'c'".
std::string listWords(const std::vector<std::string>& words);

/// The text with spaces for line ends and other characters that a terminal obeys.
std::string oneLine(std::string_view text);

/// The word that is fewest keystrokes away from `word` (a letter more, less, other, or two swapped), if a third of
/// them at most differ; otherwise an empty string.
std::string nearestWord(std::string_view word, const std::vector<std::string>& words);

}  // namespace ease
