// Edges, interior hinges and boundary loops of a triangle mesh.
//
//        opposite[0]
//           /  \          edge (a, b), a < b
//          / t0 \         inside: triangle[0] = t0 runs from a to b in its own order, triangle[1] = t1 from b to a
//         a------b
//          \ t1 /         boundary: triangle[0] is the only triangle and runs either way; triangle[1] = opposite[1] =
//          -1
//           \  /
//        opposite[1]
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct Edge {
  std::array<int, 2> vertex;
  std::array<int, 2> triangle;
  std::array<int, 2> opposite;
  bool isBoundary() const { return triangle[1] < 0; }
  /// The triangle on the other side of the edge from triangle `t`; -1 on the boundary.
  int triangleAcross(int t) const { return triangle[0] == t ? triangle[1] : triangle[0]; }
};

struct Topology {
  std::vector<Edge> edges;                                                // sorted by (vertex[0], vertex[1])
  Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor> triangle_edges;  // edge opposite to each corner
  std::vector<std::vector<int>> boundary_loops;  // vertices in order along the boundary, longest loop (m) first
};

/// The edge between two vertices as a key for sets and maps: the smaller number first.
inline std::array<int, 2> edgeKey(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

/// Throws InputError, naming `name` and the edge's vertices, where an edge has more than two triangles, where two
/// adjacent triangles have opposite orientations, or where a vertex joins two fans of triangles that share no edge
/// there.  Vertices without triangles are allowed.
Topology buildTopology(const TriangleMesh& mesh, const std::string& name);

/// Vertices joined to each vertex by an edge, in the order of the edges.
std::vector<std::vector<int>> vertexNeighbours(const Topology& topology, int vertex_count);

/// Mean length of all edges, m.
double meanEdgeLength(const Topology& topology, const Positions& positions);

}  // namespace ease
