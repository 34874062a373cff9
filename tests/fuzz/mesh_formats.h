// A mesh as the bytes of a file, in every format that Ease reads.
#pragma once

#include <string>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// What files of each format are called; bytesOf() goes by these names.
inline const std::vector<std::string> kMeshFiles = {"mesh.obj",          "mesh.off",       "ascii.ply",
                                                    "little_endian.ply", "big_endian.ply", "ascii.stl",
                                                    "binary.stl",        "ascii.vtp",      "written.vtp"};

/// `written.vtp` as Ease writes it: compressed, binary.
std::string bytesOf(const TriangleMesh& mesh, const std::string& file);

}  // namespace ease
