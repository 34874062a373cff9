// Moves the vertices of a garment onto its exact surface, its boundary into the cutting planes, and both clear of the
// body.
#pragma once

#include <vector>

#include "collision/body/surface_relaxation.h"
#include "garment/plane_cut.h"

namespace ease {

/// Puts the vertices onto the field's zero surface, evenly spread; those on the boundary glide along the curve where
/// the surface meets the plane that they lie in.
void settleOnSurface(const DistanceField& field, const std::vector<Plane>& cuts, TriangleMesh& mesh);

/// Moves vertices out until every vertex, edge midpoint and centroid is at least `clearance` (m) and a little more
/// outside of `body`; those on the boundary stay in their plane.
void keepClear(const DistanceField& body, const std::vector<Plane>& cuts, double clearance, TriangleMesh& mesh);

}  // namespace ease
