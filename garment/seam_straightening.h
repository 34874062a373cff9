// Moves the chains of edges that stand for seams onto the lines that the seams should follow.
//
// Each vertex of a chain moves to the middle of its neighbours in the chain, then to the nearest point of the line.
// Vertices within a few rings of the chain move to the middle of all their neighbours, boundary vertices only along
// their loop.  All stay on the original surface of the garment.  The ends of a chain on the boundary move to the ends
// of the line; vertices where chains meet do not move.
#pragma once

#include <vector>

#include "garment/seam.h"
#include "solver/mesh/topology.h"

namespace ease {

/// The line that a seam should follow, m.
struct SeamLine {
  std::vector<Vec3> points;
  bool is_closed;
};

Vec3 nearestOn(const SeamLine& line, const Vec3& x);

/// Moves the chains of the seams onto `lines`, one per seam.  `stays`: by vertex, whether it does not move at all;
/// empty: none of them.
void straightenSeams(const std::vector<Seam>& seams, std::vector<SeamLine> lines, const Topology& topology,
                     TriangleMesh& mesh, const std::vector<char>& stays = {});

/// Removes vertices whose two neighbours in the chain share an edge: straightening the chain would flatten the triangle
/// of the three.  `neighbours`: of every vertex of the mesh.
void removeDetours(const std::vector<std::vector<int>>& neighbours, std::vector<int>& chain);

}  // namespace ease
