// Moves the chains of edges that stand for seams onto the lines that the seams should follow.
//
// A chain's vertices go to the middle of their neighbours in it, then to the nearest point of the line; those within a
// few rings of the chain to the middle of all their neighbours, those of boundary loops along their loop.  All stay on
// the surface that the garment had.  A chain's ends go to the ends of the line; where chains meet, they stay.
#pragma once

#include <vector>

#include "garment/seam.h"
#include "solver/mesh/topology.h"

namespace ease {

/// A seam as it should run, m.
struct SeamLine {
  std::vector<Vec3> points;
  bool is_closed;
};

Vec3 nearestOn(const SeamLine& line, const Vec3& x);

/// `lines`: one for each seam.
void straightenSeams(const std::vector<Seam>& seams, std::vector<SeamLine> lines, const Topology& topology,
                     TriangleMesh& mesh);

}  // namespace ease
