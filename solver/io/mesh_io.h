// Reading and writing triangle meshes.
#pragma once

#include <filesystem>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Reads PLY, OBJ, STL (its exactly coincident points merged) or VTP by the file's extension.  Vertices keep the file's
/// order, those that no triangle uses included; a polygon is cut into a fan from its first corner; points, lines,
/// normals and textures are left out.  Throws InputError, naming the file, if it is missing, unreadable, cut short, of
/// another kind, without triangles, or has an index out of range or a coordinate that is not finite.
TriangleMesh readMesh(const std::filesystem::path& file);

/// Writes an OBJ with 17 significant digits, to a temporary name first, then renamed.  Throws ComputationError naming
/// the file.
void writeObj(const std::filesystem::path& file, const TriangleMesh& mesh);

}  // namespace ease
