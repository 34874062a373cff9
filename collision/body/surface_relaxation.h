// Improves the triangles of a mesh on a surface that is known exactly: vertices glide along the surface to the middle
// of their neighbours, and edges flip to be Delaunay (the two angles opposite to an edge sum to at most 180 degrees).
#pragma once

#include "collision/body/distance_field.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Returns the point where the surface `field` = 0 is reached from `x` along the gradient.
Vec3 ontoSurface(const DistanceField& field, const Vec3& x);

/// Improves a mesh of the surface `field` = 0 by `passes` rounds of gliding, with flips between them.  Boundary
/// vertices do not move.
void relaxOnSurface(const DistanceField& field, int passes, TriangleMesh& mesh);

}  // namespace ease
