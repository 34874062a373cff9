// Checks that a mesh passes before anything is computed with it.
//
// Vertices and triangles are counted from 0 in every message.
#pragma once

#include <string>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Largest coordinate that a mesh may have, in its file's unit: far beyond any garment, and small
/// enough that squares and cells of a grid can be computed.
inline constexpr double kMaxCoordinate = 1e9;

/// Throws InputError naming the first vertex with a coordinate that is NaN, infinite or beyond `kMaxCoordinate`.
void checkCoordinates(const Positions& positions, const std::string& name);

/// Throws InputError, naming `name`, the first vertex or triangle at fault and its value: coordinates as above; a
/// triangle with a repeated vertex or with an area below 1e-12 of the squared mesh diagonal.
void checkGeometry(const TriangleMesh& mesh, const std::string& name);

/// Throws InputError naming the first vertex without a triangle, which would have no mass in a garment.
void checkVerticesUsed(const TriangleMesh& mesh, const std::string& name);

/// Throws InputError where two poses have different numbers of vertices or triangles, or a triangle with other
/// vertices, naming the first that differs; suggests `match = "triangles"` where the triangles correspond one to one
/// in their order.
void checkSameTriangles(const TriangleMesh& first, const std::string& first_name, const TriangleMesh& other,
                        const std::string& other_name);

/// Renumbers `other`'s vertices as in `first`, going by the order of the triangles.  Throws InputError, naming the
/// triangle, if a vertex would need two numbers.
TriangleMesh matchByTriangles(const TriangleMesh& first, const std::string& first_name, const TriangleMesh& other,
                              const std::string& other_name);

}  // namespace ease
