// The sewing pattern in the page of the run that it was made from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ease {

constexpr const char* kPatternBegins = "<!-- pattern -->";
constexpr const char* kPatternEnds = "<!-- end of pattern -->";

/// Puts pattern.png, pattern_resewn.png where there is one, the summary that the program prints and the warnings into
/// fit.html of the same directory, in place of those of an earlier pattern.  Does nothing where there is no such page.
/// Throws ComputationError naming the file.
void showPatternInPage(const std::filesystem::path& directory, const std::string& summary,
                       const std::vector<std::string>& warnings);

}  // namespace ease
