// Checks that the files of a command's result directory are complete.  Files for ParaView are read with VTK's readers.
#pragma once

#include <compare>
#include <filesystem>
#include <string>
#include <vector>

namespace ease {

/// Returns the files that the list of a series names, in its order.  Throws std::runtime_error if the list is
/// incomplete.
std::vector<std::filesystem::path> framesListed(const std::filesystem::path& pvd);

/// The description of one array in a .vtp file.
struct WrittenArray {
  std::string name;
  std::string element;  // "vertex" or "triangle"
  int components;       // values per vertex or triangle
  auto operator<=>(const WrittenArray&) const = default;
};

/// Returns the arrays of a .vtp file, those of vertices first.  Throws std::runtime_error if VTK cannot read the file.
std::vector<WrittenArray> arraysIn(const std::filesystem::path& vtp);

/// Returns the first fault found in the files below `directory`, or an empty string.  Faults are a truncated or damaged
/// file, a temporary file, a missing frame that a list names, and a frame that no list names.  `killed`: the program
/// was killed, so temporary files and one unnamed frame per series are no faults.
std::string faultIn(const std::filesystem::path& directory, bool killed = false);

}  // namespace ease
