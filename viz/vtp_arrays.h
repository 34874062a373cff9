// Arrays of a .vtp file that Ease wrote.
#pragma once

#include <filesystem>

#include "viz/vtp.h"

namespace ease {

/// The mesh of a .vtp file and its arrays of triangles with these names.
struct VtpMesh {
  TriangleMesh mesh;
  std::vector<NamedArray> triangle_arrays;
};

/// Throws InputError naming the file where it is missing or is no file of triangles, or lacks an array.
VtpMesh readVtpArrays(const std::filesystem::path& file, const std::vector<std::string>& names);

}  // namespace ease
