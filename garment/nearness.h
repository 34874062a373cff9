// Rejects points so far from a surface that projecting them onto it would be arbitrary.
#pragma once

#include <string>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Distance from `x` to the nearest triangle of a mesh, m.
double distanceTo(const TriangleMesh& mesh, const Vec3& x);

/// Largest allowed distance of a point from a surface, m: of a point on a line along the surface (kNearLine), and of a
/// point that only selects a part of the surface (kNearPart).
inline constexpr double kNearLine = 0.1, kNearPart = 0.2;

/// Throws InputError if `x` is more than `farthest` (m) from the mesh: "WHAT = [x, y, z] is D m from WHERE: ...".
void expectNear(const TriangleMesh& mesh, const Vec3& x, double farthest, const std::string& what,
                const std::string& where);

}  // namespace ease
