// The files that a list of names in a scene stands for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ease {

/// Replaces each name that has * or ? in its last part by the files that match, and each folder by the mesh files in
/// it, as people number them (scan_2 before scan_10). Names are relative to `folder` before and after. Returns an empty
/// list where a name matches nothing, and sets `missing` to it.
std::vector<std::string> expandFiles(const std::vector<std::string>& names, const std::filesystem::path& folder,
                                     std::string& missing);

/// Whether a comes before b where runs of digits count as numbers.
bool comesBeforeAsNumbered(const std::string& a, const std::string& b);

/// Names in one line: all, or of many the first two, how many, and the last.
std::string shortList(const std::vector<std::string>& names);

}  // namespace ease
