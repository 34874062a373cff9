#include "adaption/rest_metric.h"

#include <algorithm>
#include <cmath>

#include "solver/base/parallel.h"
#include "solver/base/percentile.h"

namespace ease {

namespace {

constexpr double kMinAreaShare = 0.1;  // of the area asked for: a flat triangle below that is a sliver

/// Edge of a flat triangle opposite to a corner, m.
Eigen::Vector2d edgeOpposite(const Mat2& edges, int corner) {
  if (corner == 0) return edges.col(1) - edges.col(0);
  return edges.col(corner == 1 ? 1 : 0);
}

/// Corner of triangle t opposite to its edge e.
int cornerOppositeTo(const Topology& topology, int t, int e) {
  int corner = 0;
  while (topology.triangle_edges(t, corner) != e) ++corner;
  return corner;
}

/// The longest of the lengths that the one or two triangles at an edge give it.
template <class LengthIn>
double longestAtEdge(const Topology& topology, int e, const LengthIn& length) {
  const auto [t0, t1] = topology.edges[e].triangle;
  const double first = length(t0, cornerOppositeTo(topology, t0, e));
  return t1 < 0 ? first : std::max(first, length(t1, cornerOppositeTo(topology, t1, e)));
}

}  // namespace

Mat2 flatTriangle(double length_01, double length_02, double length_12, const Mat2& wanted) {
  const double x = (length_01 * length_01 + length_02 * length_02 - length_12 * length_12) / (2.0 * length_01);
  const double y_squared = length_02 * length_02 - x * x;
  if (y_squared <= 0.0) return wanted;
  Mat2 flat;
  flat << length_01, x, 0.0, std::sqrt(y_squared);
  if (flat.determinant() < kMinAreaShare * wanted.determinant()) return wanted;
  const Mat2 map = wanted * flat.inverse();  // its nearest rotation turns `flat` onto `wanted`
  const Eigen::Rotation2Dd turn(std::atan2(map(1, 0) - map(0, 1), map(0, 0) + map(1, 1)));
  return turn.toRotationMatrix() * flat;
}

void growMetric(const std::vector<Mat2>& growth, Cloth& cloth) {
  const Topology& topology = cloth.topology();
  const std::vector<Mat2>& now = cloth.restEdges();
  const auto grows = [&](int t) { return growth[t] != Mat2::Identity(); };
  std::vector<double> lengths(topology.edges.size());
  parallelFor(static_cast<int>(lengths.size()), 512, [&](int e) {
    lengths[e] = longestAtEdge(topology, e,
                               [&](int t, int corner) { return (growth[t] * edgeOpposite(now[t], corner)).norm(); });
  });
  RestShape rest{cloth.restPositions(), now};
  parallelFor(cloth.triangleCount(), 512, [&](int t) {
    bool changes = grows(t);
    for (int corner = 0; corner < 3; ++corner) {
      const int other = topology.edges[topology.triangle_edges(t, corner)].triangleAcross(t);
      changes = changes || (other >= 0 && grows(other));
    }
    if (!changes) return;
    const auto length = [&](int corner) { return lengths[topology.triangle_edges(t, corner)]; };
    rest.edges[t] = flatTriangle(length(2), length(1), length(0), growth[t] * now[t]);
  });
  cloth.setRest(rest);
}

MetricError metricError(const Cloth& cloth, const Positions& x) {
  const Topology& topology = cloth.topology();
  std::vector<double> errors;
  double sum = 0.0;
  for (int e = 0; e < std::ssize(topology.edges); ++e) {
    const double length = longestAtEdge(
        topology, e, [&](int t, int corner) { return edgeOpposite(cloth.restEdges()[t], corner).norm(); });
    const auto [a, b] = topology.edges[e].vertex;
    errors.push_back(std::abs((x.row(a) - x.row(b)).norm() / length - 1.0));
    sum += errors.back();
  }
  if (errors.empty()) return {};
  return {sum / static_cast<double>(errors.size()), percentile(errors, 0.99)};
}

}  // namespace ease
