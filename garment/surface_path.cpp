#include "garment/surface_path.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace ease {
namespace {

/// A node on the front of the search.  The smallest estimate comes first, among equal ones the smallest node, so that
/// paths are reproducible.
struct Entry {
  double estimate;  // lower bound of the length of a path through the node, m
  int node;
  bool operator>(const Entry& other) const {
    return estimate != other.estimate ? estimate > other.estimate : node > other.node;
  }
};

}  // namespace

EdgePoint SurfacePaths::point(int node) const {
  const int edge = node / kNodesOnEdge;
  return {edge, topology_.edges[edge].vertex, (node % kNodesOnEdge + 0.5) / kNodesOnEdge};
}

Vec3 SurfacePaths::position(int node) const {
  const EdgePoint p = point(node);
  return (1.0 - p.t) * mesh_.positions.row(p.vertex[0]) + p.t * mesh_.positions.row(p.vertex[1]);
}

int SurfacePaths::nearestAmong(const std::vector<int>& edges, const Vec3& x) const {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const int e : edges)
    for (int k = 0; k < kNodesOnEdge; ++k) {
      const double distance = (position(kNodesOnEdge * e + k) - x).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      nearest = kNodesOnEdge * e + k;
    }
  return nearest;
}

int SurfacePaths::nearestNode(const Vec3& x) const {
  std::vector<int> edges(topology_.edges.size());
  for (size_t e = 0; e < edges.size(); ++e) edges[e] = static_cast<int>(e);
  return nearestAmong(edges, x);
}

int SurfacePaths::nearestNodeOf(int vertex) const {
  std::vector<int> edges;
  for (size_t e = 0; e < topology_.edges.size(); ++e)
    if (topology_.edges[e].vertex[0] == vertex || topology_.edges[e].vertex[1] == vertex)
      edges.push_back(static_cast<int>(e));
  return nearestAmong(edges, mesh_.positions.row(vertex));
}

std::optional<std::vector<int>> SurfacePaths::shortest(int start, int goal) const {
  const size_t count = kNodesOnEdge * topology_.edges.size();
  std::vector<double> length(count, std::numeric_limits<double>::infinity());
  std::vector<int> before(count, -1);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  const Vec3 end = position(goal);
  length[start] = 0.0;
  front.push({(position(start) - end).norm(), start});
  while (!front.empty()) {
    const auto [estimate, node] = front.top();
    front.pop();
    if (node == goal) break;
    const Vec3 here = position(node);
    if (estimate > length[node] + (here - end).norm()) continue;  // a shorter path to the node was found since
    const int edge = node / kNodesOnEdge;
    for (const int t : topology_.edges[edge].triangle)
      for (int k = 0; t >= 0 && k < 3; ++k) {
        const int other = topology_.triangle_edges(t, k);
        for (int next = kNodesOnEdge * other; other != edge && next < kNodesOnEdge * (other + 1); ++next) {
          const Vec3 there = position(next);
          const double reached = length[node] + (there - here).norm();
          if (reached >= length[next]) continue;
          length[next] = reached;
          before[next] = node;
          front.push({reached + (there - end).norm(), next});
        }
      }
  }
  if (length[goal] == std::numeric_limits<double>::infinity()) return std::nullopt;
  std::vector<int> path = {goal};
  while (path.back() != start) path.push_back(before[path.back()]);
  std::reverse(path.begin(), path.end());
  return path;
}

bool SurfacePaths::shareTriangle(int p, int q, int r) const {
  for (const int t : topology_.edges[p / kNodesOnEdge].triangle) {
    if (t < 0) continue;
    const auto holds = [&](int node) { return (topology_.triangle_edges.row(t).array() == node / kNodesOnEdge).any(); };
    if (holds(q) && holds(r)) return true;
  }
  return false;
}

EdgeCurve SurfacePaths::curve(std::vector<int> nodes, bool is_closed) const {
  // A node is a detour if one triangle holds it and both its neighbours, or if it lies on the same edge as the next
  // node.  The removal of a detour can turn another node into one.
  const auto isDetour = [&](int before, int here, int after) {
    return here / kNodesOnEdge == after / kNodesOnEdge || shareTriangle(here, before, after);
  };
  bool has_changed = true;
  while (has_changed) {
    has_changed = false;
    const int first = is_closed ? 0 : 1, rest = is_closed ? 0 : 1;
    for (int i = first; i < static_cast<int>(nodes.size()) - rest && nodes.size() > 2;) {
      const int n = static_cast<int>(nodes.size());
      if (isDetour(nodes[(i + n - 1) % n], nodes[i], nodes[(i + 1) % n])) {
        nodes.erase(nodes.begin() + i);
        has_changed = true;
      } else {
        ++i;
      }
    }
  }
  EdgeCurve curve;
  curve.is_closed = is_closed;
  for (const int node : nodes) curve.points.push_back(point(node));
  return curve;
}

}  // namespace ease
