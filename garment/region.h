// Extracts the part of the body that loops enclose around a point: the part that becomes cloth.
#pragma once

#include <vector>

#include "garment/curve_cut.h"
#include "garment/looped_mesh.h"

namespace ease {

/// Cuts the body exactly along the loops and takes the part around the point of its surface nearest to `seed` (m).
/// Every loop must bound that part.  Throws InputError naming the loops that do not: the seed lies outside of them, or
/// they enclose nothing; or where the seed is far from the body.
LoopedMesh enclosedRegion(const TriangleMesh& body, const Topology& topology, const std::vector<BoundaryLoop>& loops,
                          const Vec3& seed);

}  // namespace ease
