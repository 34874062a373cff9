// Tool 2: extracts the part of the body around a point, up to the loops; it becomes cloth.
#pragma once

#include <vector>

#include "garment/curve_cut.h"
#include "garment/looped_mesh.h"

namespace ease {

/// Cuts the body exactly along the loops and returns the part that holds the surface point nearest to `seed`
/// (m).  Every loop must bound that part.  Throws InputError naming the loops that do not, because the seed lies
/// outside of them or they enclose nothing; also throws it if the seed is far from the body.
LoopedMesh enclosedRegion(const TriangleMesh& body, const Topology& topology, const std::vector<BoundaryLoop>& loops,
                          const Vec3& seed);

}  // namespace ease
