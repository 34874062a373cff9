#include "garment/pieces.h"

#include <algorithm>
#include <array>
#include <set>

#include "solver/mesh/disjoint_sets.h"
#include "solver/mesh/topology.h"

namespace ease {
namespace {

std::set<std::array<int, 2>> edgesOf(const std::vector<Seam>& seams) {
  std::set<std::array<int, 2>> edges;
  for (const Seam& seam : seams) {
    const size_t n = seam.vertices.size();
    for (size_t i = 0; i + (seam.is_closed ? 0 : 1) < n; ++i) {
      const int a = seam.vertices[i], b = seam.vertices[(i + 1) % n];
      edges.insert({std::min(a, b), std::max(a, b)});
    }
  }
  return edges;
}

}  // namespace

Pieces cutIntoPieces(const TriangleMesh& garment, const std::vector<Seam>& seams) {
  const Topology topology = buildTopology(garment, "garment");
  const std::set<std::array<int, 2>> seam_edges = edgesOf(seams);
  const int triangles = static_cast<int>(garment.triangles.rows());
  // Triangles on both sides of an edge that is no seam stay together: their corners there become one vertex.
  DisjointSets corners(3 * triangles), parts(triangles);  // corner k of triangle t is number 3 t + k
  for (const Edge& edge : topology.edges) {
    if (edge.isBoundary() || seam_edges.contains(edge.vertex)) continue;
    const auto [s, t] = edge.triangle;
    parts.join(s, t);
    for (const int v : edge.vertex)
      corners.join(3 * s + cornerOf(garment.triangles, s, v), 3 * t + cornerOf(garment.triangles, t, v));
  }

  Pieces pieces;
  std::vector<int> vertex(3 * triangles, -1), piece(triangles, -1);
  pieces.mesh.triangles.resize(triangles, 3);
  for (int t = 0; t < triangles; ++t) {
    int& number = piece[parts.find(t)];
    if (number < 0) number = pieces.count++;
    pieces.piece.push_back(number);
    for (int k = 0; k < 3; ++k) {
      int& v = vertex[corners.find(3 * t + k)];
      if (v < 0) {
        v = static_cast<int>(pieces.glue.size());
        pieces.glue.push_back(garment.triangles(t, k));
      }
      pieces.mesh.triangles(t, k) = v;
    }
  }
  pieces.mesh.positions.resize(pieces.glue.size(), 3);
  for (size_t v = 0; v < pieces.glue.size(); ++v) pieces.mesh.positions.row(v) = garment.positions.row(pieces.glue[v]);
  return pieces;
}

}  // namespace ease
