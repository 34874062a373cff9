// Reading and writing triangle meshes.
#pragma once

#include <filesystem>

#include "solver/mesh/polygons.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Reads a PLY, OBJ, STL, OFF or VTP file; the file's extension says which. Vertices and faces keep the order of the
/// file, and vertices that no face uses are kept. Each triangle of an STL file gets three vertices of its own. Triangle
/// strips become triangles. Points, lines, normals and textures are skipped without being checked. Coordinates are in
/// the file's unit.
///
/// Throws InputError, which names the file, if the file is missing, unreadable, cut short, of another format or without
/// faces, if an index is out of range, or if a coordinate is not finite or beyond
/// kMaxCoordinate (mesh_checks.h).
Polygons readPolygons(const std::filesystem::path& file);

/// Whether the file's name ends as that of a mesh which can be read.
bool isMeshFile(const std::filesystem::path& file);

/// Whether the file's format (STL) gives every triangle vertices of its own.
bool sharesNoVertices(const std::filesystem::path& file);

/// Reads a mesh as readPolygons(), and cuts its polygons into triangles. The triangles of an STL file are joined where
/// their edges lie at one place (solver/mesh/weld.h); vertices are then numbered in order of first appearance.
TriangleMesh readMesh(const std::filesystem::path& file);

/// Writes an OBJ file with 17 significant digits. The file is written under a temporary name and then renamed, so that
/// a half-written file never has the final name. Throws ComputationError, which names the file.
void writeObj(const std::filesystem::path& file, const TriangleMesh& mesh);

}  // namespace ease
