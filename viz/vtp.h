// One mesh with named arrays as a .vtp file (VTK XML), compressed binary, single precision; points in double precision
// where they lie far from the origin.
//
//   positions        n x 3, m
//   vertex arrays    one tuple per vertex
//   triangle arrays  one tuple per triangle
//
// The data is compressed with LZ4, which takes an eighth of zlib's time, and stored inline as base64.  Appended raw
// data would be a quarter smaller, but ParaView 5.11 cannot read it with expat 2.6 or with an older expat that has the
// fixes of 2.6 (VTK issue 19258).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// A named array with one tuple per vertex or per triangle.  The name of an array with a unit ends in it ("gap_m").
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

/// Writes one mesh with its arrays under a temporary name and then renames the file.  Throws ComputationError naming
/// the file and the reason: an error of the file system, a triangle with an invalid vertex index, or an array whose
/// length does not match the mesh.
void writeVtp(const std::filesystem::path& file, const Triangles& triangles, const Frame& frame);

}  // namespace ease
