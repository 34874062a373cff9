#include "apps/mesh_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "solver/io/mesh_io.h"

namespace ease {

namespace {

namespace fs = std::filesystem;

constexpr size_t kShortList = 8;  // names that are told one by one

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Takes a run of digits without zeros in front.
std::string_view takeNumber(std::string_view& text) {
  while (text.size() > 1 && text[0] == '0' && isDigit(text[1])) text.remove_prefix(1);
  size_t end = 0;
  while (end < text.size() && isDigit(text[end])) ++end;
  const std::string_view number = text.substr(0, end);
  text.remove_prefix(end);
  return number;
}

/// Whether the name is what the pattern says; goes back to the last * where it is not.
bool matches(std::string_view pattern, std::string_view name) {
  size_t p = 0, n = 0, star = std::string_view::npos, resume = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++p;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++resume;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::vector<std::string> filesIn(const fs::path& folder, const fs::path& shown, const std::string& pattern) {
  std::vector<std::string> found;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, unreadable)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file(unreadable) && name.front() != '.' && isMeshFile(entry.path()) && matches(pattern, name))
      found.push_back((shown / name).string());
  }
  std::sort(found.begin(), found.end(), comesBeforeAsNumbered);
  return found;
}

}  // namespace

bool comesBeforeAsNumbered(const std::string& a, const std::string& b) {
  std::string_view x = a, y = b;
  while (!x.empty() && !y.empty()) {
    if (isDigit(x[0]) && isDigit(y[0])) {
      const std::string_view m = takeNumber(x), n = takeNumber(y);
      if (m.size() != n.size()) return m.size() < n.size();
      if (m != n) return m < n;
      continue;
    }
    if (x[0] != y[0]) return x[0] < y[0];
    x.remove_prefix(1);
    y.remove_prefix(1);
  }
  return x.size() != y.size() ? x.size() < y.size() : a < b;
}

std::vector<std::string> expandFiles(const std::vector<std::string>& names, const fs::path& folder,
                                     std::string& missing) {
  std::vector<std::string> files;
  for (const std::string& name : names) {
    const fs::path path = name;
    const bool is_pattern = path.filename().string().find_first_of("*?") != std::string::npos;
    std::error_code none;
    std::vector<std::string> found = {name};
    if (fs::exists(folder / path, none) && !fs::is_directory(folder / path, none))
      found = {name};  // a file whose name has a * in it is that file
    else if (is_pattern)
      found = filesIn(folder / path.parent_path(), path.parent_path(), path.filename().string());
    else if (fs::is_directory(folder / path, none))
      found = filesIn(folder / path, path, "*");
    if (found.empty()) {
      missing = name;
      return {};
    }
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

std::string shortList(const std::vector<std::string>& names) {
  if (names.size() <= kShortList) return fmt::format("{}", fmt::join(names, ", "));
  return fmt::format("{}, {}, ... {} ({} in all)", names[0], names[1], names.back(), names.size());
}

}  // namespace ease
