#include "adaption/stitch.h"

#include <algorithm>
#include <cmath>

#include "adaption/growth.h"
#include "adaption/stretch_measure.h"
#include "solver/base/error.h"
#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr int kIterations = 10;
constexpr int kEmbeddingIterations = 300;
constexpr double kNearness = 1e-3;  // share of a vertex's diagonal entry; keeps parts that do not grow in place

/// Cosine of the angle by which the mesh is bent across an edge.
double bendCosine(const Cloth& cloth, const Positions& x, const Edge& edge) {
  const auto normal = [&](int t) {
    const auto corners = cloth.triangles().row(t);
    return doubleAreaNormal(x.row(corners[0]), x.row(corners[1]), x.row(corners[2])).normalized();
  };
  return normal(edge.triangle[0]).dot(normal(edge.triangle[1]));
}

/// The smallest edges that are at least as long as `wanted` and as `growth` times the present `edges` in every
/// direction.
Mat2 atLeastBoth(const Mat2& wanted, const Mat2& growth, const Mat2& edges) {
  if (growth == Mat2::Identity()) return wanted;
  const Mat2 map = growth * edges * wanted.inverse();
  const Stretch s = principalStretch(map.transpose() * map);
  return growthTensor(std::max(1.0, s.sigma_1), std::max(1.0, s.sigma_2), s.direction) * wanted;
}

}  // namespace

Mat32 nearestRotation(const Mat32& A) {
  // A (AᵀA)^-1/2 with the square root of a 2x2 matrix, C^1/2 = (C + d I)/sqrt(tr C + 2 d), d = sqrt(det C).
  const Mat2 C = A.transpose() * A;
  const double d = std::sqrt(std::max(0.0, C.determinant()));
  const double scale = std::sqrt(C.trace() + 2.0 * d);
  const Mat2 root = (C + d * Mat2::Identity()) / scale;
  return A * root.inverse();
}

int foldedEdges(const Cloth& cloth, const Positions& first) {
  int folded = 0;
  for (const Edge& edge : cloth.topology().edges)
    if (!edge.isBoundary() && bendCosine(cloth, cloth.restPositions(), edge) < -0.5 &&
        bendCosine(cloth, first, edge) > 0.0)
      ++folded;
  return folded;
}

Stitcher::Stitcher(const Cloth& cloth, std::span<const int> ordering)
    : system_(cloth.vertexCount(), cloth.triangles(), ordering), wanted_(cloth.first().edges) {
  std::vector<double> areas;
  for (const Mat2& edges : wanted_) {
    reference_inverse_.push_back(edges.inverse());
    areas.push_back(0.5 * edges.determinant());
  }
  std::vector<double> diagonal(cloth.vertexCount(), 0.0);
  for (int t = 0; t < cloth.triangleCount(); ++t) {
    const Mat32 b = shapeGradients(reference_inverse_[t]);
    for (int a = 0; a < 3; ++a) diagonal[cloth.triangles()(t, a)] += kNearness * areas[t] * b.row(a).squaredNorm();
  }
  if (!system_.factor(reference_inverse_, areas, diagonal))
    throw ComputationError("stitching: the garment's Laplacian is not positive definite");
  rest_edges_.resize(cloth.triangleCount());
  targets_.resize(cloth.triangleCount());
}

void Stitcher::stitch(Cloth& cloth, const std::vector<Mat2>& growth) {
  parallelFor(cloth.triangleCount(), 512,
              [&](int t) { wanted_[t] = atLeastBoth(wanted_[t], growth[t], cloth.restEdges()[t]); });
  fitWanted(cloth, kIterations);
}

void Stitcher::rescale(Cloth& cloth, const std::vector<double>& scales, int iterations) {
  for (int t = 0; t < cloth.triangleCount(); ++t) wanted_[t] *= scales[t];
  fitWanted(cloth, iterations);
}

Positions Stitcher::embed(const Cloth& cloth) {
  wanted_ = cloth.restEdges();
  x_ = cloth.restPositions();
  for (int k = 0; k < kEmbeddingIterations; ++k) {
    anchors_ = x_;
    iterate(cloth);
  }
  return x_;
}

void Stitcher::iterate(const Cloth& cloth) {
  parallelFor(cloth.triangleCount(), 512, [&](int t) {
    const Mat32 R = nearestRotation(edgeMatrix(x_, cloth.triangles(), t) * wanted_[t].inverse());
    targets_[t] = R * wanted_[t] * reference_inverse_[t];
  });
  system_.solve(targets_, anchors_, x_);
}

void Stitcher::fitWanted(Cloth& cloth, int iterations) {
  const int m = cloth.triangleCount();
  anchors_ = x_ = cloth.restPositions();
  for (int k = 0; k < iterations; ++k) iterate(cloth);
  parallelFor(m, 512, [&](int t) {
    const Mat32 edges = edgeMatrix(x_, cloth.triangles(), t);
    rest_edges_[t] = nearestRotation(edges * wanted_[t].inverse()).transpose() * edges;
  });
  cloth.setRest({x_, rest_edges_});
}

}  // namespace ease
