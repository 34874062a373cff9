// Reading and writing triangle meshes.
#pragma once

#include <filesystem>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Reads a PLY, OBJ, STL or VTP file; the file's extension says which. Vertices keep the order of the file, and
/// vertices that no triangle uses are kept. In an STL file, corners with exactly equal coordinates become one vertex. A
/// polygon is cut into a fan from its first corner. Points, lines, normals and textures are left out.
///
/// Throws InputError, which names the file, if the file is missing, unreadable, cut short, of another format or without
/// triangles, if an index is out of range, or if a coordinate is not finite.
TriangleMesh readMesh(const std::filesystem::path& file);

/// Writes an OBJ file with 17 significant digits. The file is written under a temporary name and then renamed, so that
/// a half-written file never has the final name. Throws ComputationError, which names the file.
void writeObj(const std::filesystem::path& file, const TriangleMesh& mesh);

}  // namespace ease
