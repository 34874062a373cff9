// Moves the vertices of a garment onto its exact surface and its boundary into the cutting planes, then both out of the
// body.
#pragma once

#include <vector>

#include "collision/body/surface_relaxation.h"
#include "garment/plane_cut.h"

namespace ease {

/// Spreads the vertices evenly over the field's zero surface.  Boundary vertices slide along the curve in which the
/// surface meets their cutting plane.
void settleOnSurface(const DistanceField& field, const std::vector<Plane>& cuts, TriangleMesh& mesh);

/// Moves vertices out until every vertex, edge midpoint and centroid is a little more than `clearance` (m)
/// outside of `body`; boundary vertices stay in their plane.  Throws ComputationError if the triangles are too large.
void keepClear(const DistanceField& body, const std::vector<Plane>& cuts, double clearance, TriangleMesh& mesh);

}  // namespace ease
