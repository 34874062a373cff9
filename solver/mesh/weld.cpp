#include "solver/mesh/weld.h"

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>

#include "solver/mesh/disjoint_sets.h"

namespace ease {

namespace {

constexpr double kSamePlace = 1e-6;  // of the mesh's diagonal

/// An edge that one triangle alone has, from vertex to vertex in the triangle's order, and that triangle's third
/// corner.
struct OpenEdge {
  int from, to, opposite;
};

/// A key that is the same for both directions of an edge.
std::uint64_t keyOf(int a, int b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint64_t>(std::max(a, b));
}

struct Keyed {
  std::uint64_t key;
  int side;
  bool operator<(const Keyed& other) const { return key != other.key ? key < other.key : side < other.side; }
};

std::vector<OpenEdge> openEdges(const Triangles& triangles) {
  std::vector<Keyed> sides(triangles.size());
  for (int s = 0; s < triangles.size(); ++s)
    sides[s] = {keyOf(triangles(s / 3, s % 3), triangles(s / 3, (s + 1) % 3)), s};
  tbb::parallel_sort(sides.begin(), sides.end());
  std::vector<OpenEdge> open;
  for (size_t k = 0; k < sides.size(); ++k) {
    const bool shared =
        (k > 0 && sides[k - 1].key == sides[k].key) || (k + 1 < sides.size() && sides[k + 1].key == sides[k].key);
    if (shared) continue;
    const int t = sides[k].side / 3, c = sides[k].side % 3;
    open.push_back({triangles(t, c), triangles(t, (c + 1) % 3), triangles(t, (c + 2) % 3)});
  }
  return open;
}

/// Numbers the places of vertices: those whose coordinates are equal to the last bit share one.
std::vector<int> exactPlaces(const Positions& x, const std::vector<int>& vertices) {
  std::vector<int> order = vertices;
  const auto comesBefore = [&](int i, int j) {
    for (int k = 0; k < 3; ++k)
      if (x(i, k) != x(j, k)) return x(i, k) < x(j, k);
    return i < j;
  };
  tbb::parallel_sort(order.begin(), order.end(), comesBefore);
  std::vector<int> place(x.rows(), -1);
  for (size_t k = 0; k < order.size(); ++k) {
    const bool repeats = k > 0 && x.row(order[k]) == x.row(order[k - 1]);
    place[order[k]] = repeats ? place[order[k - 1]] : order[k];
  }
  return place;
}

/// Joins places that are at most `reach` apart.
void joinNearPlaces(const Positions& x, double reach, const std::vector<int>& vertices, std::vector<int>& place) {
  using Cell = std::array<std::int64_t, 3>;
  const auto hash = [](const Cell& c) {
    return static_cast<size_t>(c[0] * 73856093 ^ c[1] * 19349663 ^ c[2] * 83492791);
  };
  std::unordered_map<Cell, std::vector<int>, decltype(hash)> cells(vertices.size(), hash);
  const Vec3 low = x.colwise().minCoeff();
  const auto cellOf = [&](const Vec3& p) {
    Cell cell;
    for (int k = 0; k < 3; ++k) cell[k] = static_cast<std::int64_t>(std::floor((p[k] - low[k]) / (2.0 * reach)));
    return cell;
  };
  DisjointSets sets(static_cast<int>(x.rows()));
  for (const int v : vertices) {
    if (place[v] != v) continue;
    const Vec3 p = x.row(v);
    const Cell first = cellOf(p.array() - reach), last = cellOf(p.array() + reach);
    for (auto i = first[0]; i <= last[0]; ++i)
      for (auto j = first[1]; j <= last[1]; ++j)
        for (auto k = first[2]; k <= last[2]; ++k) {
          const auto cell = cells.find({i, j, k});
          if (cell == cells.end()) continue;
          for (const int other : cell->second)
            if ((x.row(other).transpose() - p).norm() <= reach) sets.join(v, other);
        }
    cells[cellOf(p)].push_back(v);
  }
  for (const int v : vertices) place[v] = sets.find(place[v]);
}

/// Angle, rad, at which the triangle of an open edge lies around the edge: about `axis`, counted from `reference`.
double angleAround(const Positions& x, const OpenEdge& edge, const Vec3& axis, const Vec3& reference) {
  const Vec3 arm = (x.row(edge.opposite) - x.row(edge.from)).transpose();
  return std::atan2(axis.dot(reference.cross(arm)), reference.dot(arm - axis * axis.dot(arm)));
}

/// Pairs open edges that lie at one place. By the numbers of their places each runs up (forth) or down (back). Sorted
/// by angle around the edge, the two kinds must alternate; returns false where they do not. Calls pair(a, b) for each
/// edge a that runs forth and the edge b that follows it through the inside of the surface.
template <class Pair>
bool pairAround(const Positions& x, const std::vector<OpenEdge>& edges, const std::vector<int>& place,
                const Pair& pair) {
  if (edges.size() % 2 != 0) return false;
  const auto forth = [&](const OpenEdge& e) { return place[e.from] < place[e.to]; };
  if (edges.size() == 2) {
    if (forth(edges[0]) == forth(edges[1])) return false;
    pair(edges[0], edges[1]);
    return true;
  }
  const OpenEdge& any = edges.front();
  Vec3 axis = (x.row(any.to) - x.row(any.from)).transpose().normalized();
  if (!forth(any)) axis = -axis;
  const Vec3 reference = axis.unitOrthogonal();
  std::vector<std::pair<double, int>> around;
  for (size_t k = 0; k < edges.size(); ++k)
    around.emplace_back(angleAround(x, edges[k], axis, reference), static_cast<int>(k));
  std::sort(around.begin(), around.end());
  // A triangle that runs forth has its normal along axis x arm: turning about the axis leads away from the inside, and
  // turning back leads through the inside to the triangle across.
  for (size_t k = 0; k < around.size(); ++k)
    if (forth(edges[around[k].second]) == forth(edges[around[(k + 1) % around.size()].second])) return false;
  for (size_t k = 0; k < around.size(); ++k) {
    const OpenEdge& edge = edges[around[k].second];
    if (!forth(edge)) continue;
    pair(edge, edges[around[(k + around.size() - 1) % around.size()].second]);
  }
  return true;
}

class Welding {
 public:
  Welding(const Triangles& triangles, std::span<const Positions> poses)
      : poses_(poses), open_(openEdges(triangles)), sets_(static_cast<int>(poses.front().rows())) {}

  /// Joins what lies at one place; returns the number of edges that lie at the place of another and stay open.
  int join() {
    if (open_.empty()) return 0;
    const Positions& x = poses_.front();
    reach_ = kSamePlace * (x.colwise().maxCoeff() - x.colwise().minCoeff()).norm();
    std::vector<int> place = exactPlaces(x, ends());
    joinAt(place);
    if (open_.empty()) return 0;
    joinNearPlaces(x, reach_, ends(), place);
    return joinAt(place);
  }

  DisjointSets& sets() { return sets_; }

 private:
  /// Vertices of open edges.
  std::vector<int> ends() const {
    std::vector<int> vertices;
    for (const OpenEdge& edge : open_) {
      vertices.push_back(edge.from);
      vertices.push_back(edge.to);
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  bool together(int a, int b) const {
    const auto meet = [&](const Positions& x) { return (x.row(a) - x.row(b)).norm() <= 2.0 * reach_; };
    return std::all_of(poses_.begin(), poses_.end(), meet);
  }

  int joinAt(const std::vector<int>& place) {
    std::vector<Keyed> keyed;
    for (size_t e = 0; e < open_.size(); ++e)
      if (place[open_[e].from] != place[open_[e].to])
        keyed.push_back({keyOf(place[open_[e].from], place[open_[e].to]), static_cast<int>(e)});
    tbb::parallel_sort(keyed.begin(), keyed.end());
    int left = 0;
    std::vector<char> closed(open_.size(), 0);
    std::vector<OpenEdge> group;
    for (size_t begin = 0, end = 0; begin < keyed.size(); begin = end) {
      group.clear();
      for (; end < keyed.size() && keyed[end].key == keyed[begin].key; ++end) group.push_back(open_[keyed[end].side]);
      if (group.size() < 2) continue;
      bool meet_in_all_poses = true;
      const bool paired = pairAround(poses_.front(), group, place, [&](const OpenEdge& a, const OpenEdge& b) {
        if (!together(a.from, b.to) || !together(a.to, b.from)) {
          meet_in_all_poses = false;
          return;
        }
        sets_.join(a.from, b.to);
        sets_.join(a.to, b.from);
      });
      if (!paired) left += static_cast<int>(group.size());
      if (paired && meet_in_all_poses)
        for (size_t k = begin; k < end; ++k) closed[keyed[k].side] = 1;
    }
    std::vector<OpenEdge> still_open;
    for (size_t e = 0; e < open_.size(); ++e)
      if (!closed[e]) still_open.push_back(open_[e]);
    open_ = std::move(still_open);
    return left;
  }

  std::span<const Positions> poses_;
  std::vector<OpenEdge> open_;
  DisjointSets sets_;
  double reach_ = 0.0;  // m
};

}  // namespace

Weld findWeld(const Triangles& triangles, std::span<const Positions> poses, bool joins) {
  Weld weld;
  const int count = static_cast<int>(poses.front().rows());
  Welding welding(triangles, poses);
  if (joins) weld.left_open = welding.join();
  std::vector<char> used(count, 0);
  for (long k = 0; k < triangles.size(); ++k) used[triangles.data()[k]] = 1;
  weld.vertex.assign(count, -1);
  for (int v = 0; v < count; ++v) {
    if (!used[v]) {
      ++weld.unused;
      continue;
    }
    const int first = welding.sets().find(v);
    if (first != v) ++weld.welded;
    weld.vertex[v] = first == v ? weld.count++ : weld.vertex[first];
  }
  return weld;
}

Triangles welded(const Triangles& triangles, const Weld& weld) {
  Triangles result(triangles.rows(), 3);
  for (long k = 0; k < triangles.size(); ++k) result.data()[k] = weld.vertex[triangles.data()[k]];
  return result;
}

Positions welded(const Positions& positions, const Weld& weld) {
  Positions result(weld.count, 3);
  for (int v = static_cast<int>(positions.rows()) - 1; v >= 0; --v)
    if (weld.vertex[v] >= 0) result.row(weld.vertex[v]) = positions.row(v);
  return result;
}

}  // namespace ease
