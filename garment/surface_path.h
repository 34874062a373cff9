// Shortest paths on a triangle mesh, as curves that cross edges.
//
// Every edge has four nodes; two nodes are neighbours if they lie on different edges of one triangle.  A shortest path
// through the nodes is at most about one percent longer than the shortest path on the surface (Lanthier, Maheshwari and
// Sack 2001).  The search is A* with the straight distance to the goal as lower bound.
#pragma once

#include <optional>
#include <vector>

#include "garment/edge_curve.h"

namespace ease {

/// Number of nodes on each edge.
inline constexpr int kNodesOnEdge = 4;

class SurfacePaths {
 public:
  /// The mesh and the topology must outlive this object.
  SurfacePaths(const TriangleMesh& mesh, const Topology& topology) : mesh_(mesh), topology_(topology) {}

  /// Point of a node on its edge.  Node kNodesOnEdge * e + i is the i-th node on edge e.
  EdgePoint point(int node) const;
  Vec3 position(int node) const;

  /// Finds the node nearest to `x` (m); nearestNodeOf() finds the one nearest to a vertex, on the edges around it.
  int nearestNode(const Vec3& x) const;
  int nearestNodeOf(int vertex) const;
  /// Finds the node nearest to `x` (m) on these edges.
  int nearestAmong(const std::vector<int>& edges, const Vec3& x) const;

  /// Finds the nodes of the shortest path from `start` to `goal`, both included; nullopt if the two are not connected.
  std::optional<std::vector<int>> shortest(int start, int goal) const;

  /// Makes the curve through these nodes, without detours within a triangle.
  EdgeCurve curve(std::vector<int> nodes, bool is_closed) const;

 private:
  /// Whether one triangle holds all three nodes on its edges.
  bool shareTriangle(int p, int q, int r) const;

  const TriangleMesh& mesh_;
  const Topology& topology_;
};

}  // namespace ease
