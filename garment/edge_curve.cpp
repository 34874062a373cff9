#include "garment/edge_curve.h"

#include <algorithm>
#include <limits>

#include "solver/mesh/segment.h"

namespace ease {
namespace {

constexpr double kFromEnds = 0.02;  // smallest distance of a point from the ends of its edge, in edge lengths

/// Follows one isoline from edge to edge.
struct IsolineWalk {
  const Topology& topology;
  std::span<const double> values;
  std::vector<char> visited;  // by edge: whether an isoline has passed it

  bool isCrossed(int edge) const {
    const auto [a, b] = topology.edges[edge].vertex;
    return (values[a] >= 0.0) != (values[b] >= 0.0);
  }

  EdgePoint pointOn(int edge) const {
    const auto [a, b] = topology.edges[edge].vertex;
    const double t = values[a] / (values[a] - values[b]);
    return {edge, {a, b}, std::clamp(t, kFromEnds, 1.0 - kFromEnds)};
  }

  /// Finds the other edge of the triangle that the isoline crosses; -1: none.
  int across(int triangle, int edge) const {
    for (int k = 0; k < 3; ++k) {
      const int other = topology.triangle_edges(triangle, k);
      if (other != edge && isCrossed(other)) return other;
    }
    return -1;
  }

  EdgeCurve follow(int start) {
    EdgeCurve curve;
    curve.is_closed = false;
    int edge = start, triangle = topology.edges[start].triangle[0];
    while (true) {
      visited[edge] = 1;
      curve.points.push_back(pointOn(edge));
      if (triangle < 0) return curve;
      edge = across(triangle, edge);
      triangle = topology.edges[edge].triangleAcross(triangle);
      curve.is_closed = edge == start;
      if (curve.is_closed) return curve;
    }
  }
};

}  // namespace

std::vector<Vec3> placed(const EdgeCurve& curve, const Positions& positions) {
  std::vector<Vec3> points;
  for (const EdgePoint& p : curve.points)
    points.push_back((1.0 - p.t) * positions.row(p.vertex[0]) + p.t * positions.row(p.vertex[1]));
  return points;
}

double polygonLength(std::span<const Vec3> points, bool is_closed) {
  double length = is_closed && !points.empty() ? (points.front() - points.back()).norm() : 0.0;
  for (size_t i = 0; i + 1 < points.size(); ++i) length += (points[i + 1] - points[i]).norm();
  return length;
}

double polygonDistance(std::span<const Vec3> points, bool is_closed, const Vec3& x) {
  double least = std::numeric_limits<double>::infinity();
  if (is_closed && !points.empty()) least = distanceToSegment(points.back(), points.front(), x);
  for (size_t i = 0; i + 1 < points.size(); ++i)
    least = std::min(least, distanceToSegment(points[i], points[i + 1], x));
  return least;
}

std::vector<EdgeCurve> isolines(const Topology& topology, std::span<const double> values) {
  const int edges = static_cast<int>(topology.edges.size());
  IsolineWalk walk{topology, values, std::vector<char>(edges, 0)};
  std::vector<EdgeCurve> curves;
  // Open isolines first, because they must be followed from an end.
  for (const bool from_boundary : {true, false})
    for (int e = 0; e < edges; ++e)
      if (!walk.visited[e] && walk.isCrossed(e) && (!from_boundary || topology.edges[e].isBoundary()))
        curves.push_back(walk.follow(e));
  return curves;
}

}  // namespace ease
