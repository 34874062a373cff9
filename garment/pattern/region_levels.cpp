#include "garment/pattern/region_levels.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include "solver/base/parallel.h"
#include "solver/mesh/segment.h"

namespace ease {
namespace {

constexpr double kFromEnds = 1e-3;  // smallest distance of a crossing from the ends of its edge, in edge lengths
constexpr double kBand = 6.0;       // mean edge lengths
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// By how much the label of the other end of an edge lies above the own one at both ends, m.
struct Gaps {
  double a, b;
};

Gaps gapsOn(const RegionLevels& levels, const RegionMap& map, const Edge& edge) {
  const auto [a, b] = edge.vertex;
  const double *own = levels.of(map.label[a]), *other = levels.of(map.label[b]);
  return {std::max(0.0, other[a] - own[a]), std::max(0.0, own[b] - other[b])};
}

/// Least distance at which a front that passes a and b at da and db reaches x, going over the edge between them.
double arrival(const Vec2& a, const Vec2& b, const Vec2& x, double da, double db) {
  if (!std::isfinite(da) || !std::isfinite(db)) return std::min(da + (x - a).norm(), db + (x - b).norm());
  const double length = (b - a).norm(), slope = (db - da) / length;
  const Vec2 along = (b - a) / length;
  const double foot = along.dot(x - a), height = (x - a - foot * along).norm();
  double at = slope >= 1.0 ? 0.0 : slope <= -1.0 ? length : foot - slope * height / std::sqrt(1.0 - slope * slope);
  at = std::clamp(at, 0.0, length);
  return da + slope * at + std::hypot(foot - at, height);
}

/// Distances to the border of one label, of the vertices of the triangles that it crosses; else infinite.
std::vector<double> besideLines(const RestSurface& surface, const RegionMap& map, int label) {
  std::vector<double> distance(surface.vertexCount(), kInfinite);
  for (int t = 0; t < surface.triangleCount(); ++t) {
    const std::array<int, 3> labels = labelsOf(surface, map, t);
    const Division division = divide(labels);
    if (division.line_count == 0 || std::find(labels.begin(), labels.end(), label) == labels.end()) continue;
    const std::array<Vec2, 7> points = pointsOf(surface, map, t);
    for (int l = 0; l < division.line_count; ++l) {
      const auto [p, q] = division.lines[l];
      if (division.line_count == 3 && labels[p - 3] == label) continue;  // the line opposite to the label's corner
      for (int k = 0; k < 3; ++k) {
        double& d = distance[surface.mesh.triangles(t, k)];
        d = std::min(d, distanceToSegment(points[p], points[q], points[k]));
      }
    }
  }
  return distance;
}

}  // namespace

void marchDistances(const RestSurface& surface, double until, std::vector<double>& distance) {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  std::vector<char> is_final(distance.size(), 0);
  for (size_t v = 0; v < distance.size(); ++v)
    if (std::isfinite(distance[v])) front.push({distance[v], static_cast<int>(v)});
  while (!front.empty()) {
    const auto [reached, v] = front.top();
    front.pop();
    if (reached > until) break;
    if (is_final[v] || reached > distance[v]) continue;
    is_final[v] = 1;
    for (const int t : surface.triangles_around[v]) {
      const int at = cornerOf(surface.mesh.triangles, t, v);
      for (const int k : {(at + 1) % 3, (at + 2) % 3}) {
        const int w = surface.mesh.triangles(t, k), other = 3 - at - k;
        const int o = surface.mesh.triangles(t, other);
        if (is_final[w]) continue;
        const double next = arrival(surface.corner(t, at), surface.corner(t, other), surface.corner(t, k), reached,
                                    is_final[o] ? distance[o] : kInfinite);
        if (next >= distance[w]) continue;
        distance[w] = next;
        front.push({next, w});
      }
    }
  }
}

RegionLevels levelsFrom(const RestSurface& surface, const std::vector<int>& label, int labels) {
  return redistanced(surface, {label, std::vector<double>(surface.topology.edges.size(), 0.5)}, labels);
}

RegionMap mapOf(const RestSurface& surface, const RegionLevels& levels) {
  RegionMap map{std::vector<int>(surface.vertexCount(), 0), std::vector<double>(surface.topology.edges.size(), 0.5)};
  for (int v = 0; v < surface.vertexCount(); ++v)
    for (int k = 1; k < levels.labels; ++k)
      if (levels.of(k)[v] < levels.of(map.label[v])[v]) map.label[v] = k;
  for (size_t e = 0; e < surface.topology.edges.size(); ++e) {
    if (!isCrossed(map, surface.topology.edges[e])) continue;
    const Gaps gaps = gapsOn(levels, map, surface.topology.edges[e]);
    const double whole = gaps.a + gaps.b;
    map.crossing[e] = whole > 0.0 ? std::clamp(gaps.a / whole, kFromEnds, 1.0 - kFromEnds) : 0.5;
  }
  return map;
}

RegionLevels redistanced(const RestSurface& surface, const RegionMap& map, int labels) {
  const int n = surface.vertexCount();
  const double band = kBand * surface.mean_edge;
  RegionLevels levels{labels, std::vector<double>(static_cast<size_t>(labels) * n)};
  parallelFor(labels, 1, [&](int k) {
    std::vector<double> distance = besideLines(surface, map, k);
    marchDistances(surface, band, distance);
    double* phi = levels.of(k);
    for (int v = 0; v < n; ++v) {
      const double d = std::min(distance[v], band);
      phi[v] = map.label[v] == k ? -d : d;
    }
  });
  return levels;
}

}  // namespace ease
