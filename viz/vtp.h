// One mesh with named arrays as a .vtp file (VTK XML), compressed binary, single precision.
//
//   positions        n x 3, m
//   vertex arrays    one tuple per vertex
//   triangle arrays  one tuple per triangle
//
// LZ4 compression: an eighth of zlib's time.  Data inline as base64, a third larger than raw data appended, because
// ParaView 5.11 cannot read any appended data since expat 2.6 and its backported fixes (VTK issue 19258).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// A named array with one tuple per vertex or per triangle; its name ends in its unit where it has one ("gap_m").
struct NamedArray {
  std::string name;
  int components;             // per tuple
  std::vector<float> values;  // components x count
};

struct Frame {
  Positions positions;  // m
  std::vector<NamedArray> vertex_arrays;
  std::vector<NamedArray> triangle_arrays;
};

/// Writes one mesh with its arrays, to a temporary name first, then renamed.  Throws ComputationError naming the file
/// and the reason: the file system's, an index without a vertex, or an array whose length does not fit the mesh.
void writeVtp(const std::filesystem::path& file, const Triangles& triangles, const Frame& frame);

}  // namespace ease
