#include "garment/pattern/dart_ways.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

namespace ease {
namespace {

constexpr double kAside = 0.005;  // m: an edge that far beside the straight line counts as twice as long

}  // namespace

std::vector<int> Ways::to(int tip) const {
  std::vector<int> way;
  for (int v = tip; v >= 0; v = before[v]) way.push_back(v);
  std::reverse(way.begin(), way.end());
  return way;
}

PartEdges::PartEdges(const PieceMesh& part)
    : neighbours_(part.mesh.positions.rows()), is_outline_(part.mesh.positions.rows(), 0) {
  const Topology topology = buildTopology(part.mesh, "a pattern piece");
  for (const Edge& edge : topology.edges) {
    const int t = edge.triangle[0];
    const double length = edgeLengths(part.rest_edges[t])[cornerOf(part.mesh.triangles, t, edge.opposite[0])];
    if (edge.isBoundary())
      for (const int v : edge.vertex) is_outline_[v] = 1;
    neighbours_[edge.vertex[0]].emplace_back(edge.vertex[1], length);
    neighbours_[edge.vertex[1]].emplace_back(edge.vertex[0], length);
  }
}

Ways PartEdges::waysFrom(const std::vector<char>& starts, const std::vector<char>& blocked) const {
  return cheapest(starts, blocked, std::vector<double>(neighbours_.size(), 1.0));
}

std::vector<int> PartEdges::straightWay(int from, int to, const Positions& x, const std::vector<char>& blocked) const {
  const Eigen::Vector2d a = x.row(from).head<2>(), b = x.row(to).head<2>(), along = (b - a).normalized();
  std::vector<double> price(neighbours_.size());
  for (size_t v = 0; v < price.size(); ++v) {
    const Eigen::Vector2d c = x.row(static_cast<int>(v)).head<2>().transpose() - a;
    price[v] = 1.0 + std::abs(along.x() * c.y() - along.y() * c.x()) / kAside;
  }
  std::vector<char> start(neighbours_.size(), 0);
  start[from] = 1;
  const Ways ways = cheapest(start, blocked, price);
  return std::isfinite(ways.length[to]) ? ways.to(to) : std::vector<int>{};
}

/// Ways of the least length times the price of the vertices that they pass.
Ways PartEdges::cheapest(const std::vector<char>& starts, const std::vector<char>& blocked,
                         const std::vector<double>& price) const {
  Ways ways{std::vector<double>(neighbours_.size(), std::numeric_limits<double>::infinity()),
            std::vector<int>(neighbours_.size(), -1)};
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for (size_t v = 0; v < starts.size(); ++v)
    if (starts[v]) {
      ways.length[v] = 0.0;
      front.push({0.0, static_cast<int>(v)});
    }
  while (!front.empty()) {
    const auto [length, v] = front.top();
    front.pop();
    if (length > ways.length[v]) continue;
    for (const auto& [w, edge] : neighbours_[v]) {
      const double reached = length + edge * price[w];
      if (blocked[w] || reached >= ways.length[w]) continue;
      ways.length[w] = reached;
      ways.before[w] = v;
      front.push({ways.length[w], w});
    }
  }
  return ways;
}

std::vector<int> spreadTips(const Ways& ways, const Positions& x, int count) {
  std::vector<int> tips;
  std::vector<double> distance = ways.length;  // to the tips so far; to the outline before there are any
  for (int k = 0; k < count; ++k) {
    int best = -1;
    for (size_t v = 0; v < distance.size(); ++v) {
      if (!std::isfinite(ways.length[v]) || ways.length[v] < kMinDartLength) continue;
      if (distance[v] > 0.0 && (best < 0 || distance[v] > distance[best])) best = static_cast<int>(v);
    }
    if (best < 0) break;
    tips.push_back(best);
    for (size_t v = 0; v < distance.size(); ++v) {
      const double apart = (x.row(static_cast<int>(v)) - x.row(best)).norm();
      distance[v] = k == 0 ? apart : std::min(distance[v], apart);
    }
  }
  return tips;
}

}  // namespace ease
