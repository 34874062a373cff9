// Shortest paths on a triangle mesh, as curves that cross edges.
//
// Every edge bears four nodes; two nodes are neighbours where they lie on different edges of one triangle.  Shortest
// paths through such nodes come within about one percent of the shortest ones on the surface (Lanthier, Maheshwari and
// Sack 2001).  The search is A* with the straight distance to the goal as lower bound.
#pragma once

#include <optional>
#include <vector>

#include "garment/edge_curve.h"

namespace ease {

/// Number of nodes on an edge.
inline constexpr int kNodesOnEdge = 4;

class SurfacePaths {
 public:
  /// The mesh must stay for as long as this is used.
  SurfacePaths(const TriangleMesh& mesh, const Topology& topology) : mesh_(mesh), topology_(topology) {}

  /// A node is numbered kNodesOnEdge * edge + place on the edge.
  EdgePoint point(int node) const;
  Vec3 position(int node) const;

  /// The node nearest to `x` (m), anywhere on the mesh or on the edges around a vertex.
  int nearestNode(const Vec3& x) const;
  int nearestNodeOf(int vertex) const;
  /// The node nearest to `x` among those of these edges.
  int nearestAmong(const std::vector<int>& edges, const Vec3& x) const;

  /// Nodes of the shortest path from `start` to `goal`, both included; nullopt if the two are not connected.
  std::optional<std::vector<int>> shortest(int start, int goal) const;

  /// The curve through these nodes; detours within a triangle are cut short.
  EdgeCurve curve(std::vector<int> nodes, bool is_closed) const;

 private:
  /// Whether a triangle holds the edges of all three nodes.
  bool shareTriangle(int p, int q, int r) const;

  const TriangleMesh& mesh_;
  const Topology& topology_;
};

}  // namespace ease
