// The direction of the warp in every triangle of a garment.
//
// It is the grain projected into the triangle's plane. A triangle that lies across the grain (within about a degree)
// has no such direction and takes that of its neighbours, unfolded about the edge that they share.
#pragma once

#include <string>
#include <vector>

#include "solver/mesh/topology.h"

namespace ease {

/// Unit vectors, one a triangle, each in its triangle's plane. Throws InputError where a connected part lies across the
/// grain as a whole, saying what to write.
std::vector<Vec3> warpDirections(const TriangleMesh& mesh, const Topology& topology, const Vec3& grain);

}  // namespace ease
