// Points that are to lie on a surface, or nearly so: far from it, the nearest place would be any.
#pragma once

#include <string>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Distance from `x` to the nearest triangle of a mesh, m.
double distanceTo(const TriangleMesh& mesh, const Vec3& x);

/// How far from a surface a point may lie, m: one on a line, or one that says only which part is meant.
inline constexpr double kNearLine = 0.1, kNearPart = 0.2;

/// Throws InputError where `x` is more than `farthest` (m) from the mesh: "WHAT = [x, y, z] is D m from WHERE: ...".
void expectNear(const TriangleMesh& mesh, const Vec3& x, double farthest, const std::string& what,
                const std::string& where);

}  // namespace ease
