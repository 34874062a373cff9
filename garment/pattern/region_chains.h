// The edges of a mesh between regions of triangles, as chains from junction to junction.
#pragma once

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "garment/seam.h"
#include "solver/mesh/topology.h"

namespace ease {

using EdgeSet = std::set<std::array<int, 2>>;  // by their ends, the smaller first

/// Length of a seam, m; also that of a closed one.
double lengthOfSeam(const Seam& seam, const Positions& positions);
double lengthOfSeams(const std::vector<Seam>& seams, const Positions& positions);

/// Adds the edges of a seam.
void addEdges(const Seam& seam, EdgeSet& edges);

/// Inner edges whose triangles have different labels, but those of `seams`.
EdgeSet edgesBetween(const TriangleMesh& mesh, const std::vector<int>& triangle_label, const EdgeSet& seams);

/// The edges as chains called "cut 1", "cut 2" ...  They end where other than two of the edges meet, at the border and
/// at the edges of `seams`, which belong to no chain.
std::vector<Seam> chainsAlong(const TriangleMesh& mesh, const EdgeSet& edges, const EdgeSet& seams);

}  // namespace ease
