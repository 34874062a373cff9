// Whether what a command left in its directory is whole: every file opens, by VTK's own readers where ParaView would.
#pragma once

#include <compare>
#include <filesystem>
#include <string>
#include <vector>

namespace ease {

/// The files that a series' list names, in its order.  Throws std::runtime_error where the list is not whole.
std::vector<std::filesystem::path> framesListed(const std::filesystem::path& pvd);

/// What a .vtp file says about one of its arrays.
struct WrittenArray {
  std::string name;
  std::string element;  // "vertex" or "triangle"
  int components;       // values per vertex or triangle
  auto operator<=>(const WrittenArray&) const = default;
};

/// The arrays of a .vtp file, first those of vertices.  Throws std::runtime_error where VTK cannot read the file.
std::vector<WrittenArray> arraysIn(const std::filesystem::path& vtp);

/// The first fault of a file below `directory`, empty if there is none: cut short or damaged, temporary, a frame that a
/// list names and that is not there, or is there and not named.  `killed`: temporary files and one frame of each series
/// that its list does not name are no fault.
std::string faultIn(const std::filesystem::path& directory, bool killed = false);

}  // namespace ease
