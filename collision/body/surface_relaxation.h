// Better triangles on a surface that is known exactly: vertices glide along it to the middle of their neighbours, and
// edges flip to be Delaunay (the two angles opposite to an edge sum to at most 180 degrees).
#pragma once

#include <functional>
#include <vector>

#include "collision/body/limb.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

using DistanceField = std::function<Distance(const Vec3&)>;

/// Moves `x` onto the surface where `field` is zero, along its gradient.
Vec3 ontoSurface(const DistanceField& field, const Vec3& x);

/// Improves a mesh of the field's zero surface by `passes` of gliding, with flips between them.  The boundary stays as
/// it is.
void relaxOnSurface(const DistanceField& field, int passes, TriangleMesh& mesh);

}  // namespace ease
