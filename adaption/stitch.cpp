#include "adaption/stitch.h"

#include <cmath>

#include "solver/linear/parallel.h"
#include "solver/mesh/error.h"

namespace ease {

namespace {

constexpr int kIterations = 10;
constexpr double kNearness = 1e-3;  // of a vertex's part of the matrix: what does not grow stays where it is

}  // namespace

Mat32 nearestRotation(const Mat32& A) {
  // A (AᵀA)^-1/2 with the square root of a 2x2 matrix, C^1/2 = (C + d I)/sqrt(tr C + 2 d), d = sqrt(det C).
  const Mat2 C = A.transpose() * A;
  const double d = std::sqrt(std::max(0.0, C.determinant()));
  const double scale = std::sqrt(C.trace() + 2.0 * d);
  const Mat2 root = (C + d * Mat2::Identity()) / scale;
  return A * root.inverse();
}

Stitcher::Stitcher(const Cloth& cloth)
    : system_(cloth.vertexCount(), cloth.triangles()), reference_inverse_(cloth.restInverse()) {
  std::vector<double> diagonal(cloth.vertexCount(), 0.0);
  for (int t = 0; t < cloth.triangleCount(); ++t) {
    const Mat32 b = shapeGradients(reference_inverse_[t]);
    for (int a = 0; a < 3; ++a)
      diagonal[cloth.triangles()(t, a)] += kNearness * cloth.restAreas()[t] * b.row(a).squaredNorm();
  }
  if (!system_.factor(reference_inverse_, cloth.restAreas(), diagonal))
    throw ComputationError("stitching: the garment's Laplacian is not positive definite");
  wanted_.resize(cloth.triangleCount());
  rest_edges_.resize(cloth.triangleCount());
  targets_.resize(cloth.triangleCount());
}

void Stitcher::stitch(Cloth& cloth, const std::vector<Mat2>& growth) {
  const int m = cloth.triangleCount();
  anchors_ = x_ = cloth.restPositions();
  parallelFor(m, 512, [&](int t) { wanted_[t] = growth[t] * cloth.restEdges()[t]; });
  for (int k = 0; k < kIterations; ++k) {
    parallelFor(m, 512, [&](int t) {
      const Mat32 R = nearestRotation(edgeMatrix(x_, cloth.triangles(), t) * wanted_[t].inverse());
      targets_[t] = R * wanted_[t] * reference_inverse_[t];
    });
    system_.solve(targets_, anchors_, x_);
  }
  parallelFor(m, 512, [&](int t) {
    const Mat32 edges = edgeMatrix(x_, cloth.triangles(), t);
    rest_edges_[t] = nearestRotation(edges * wanted_[t].inverse()).transpose() * edges;
  });
  cloth.setRest(x_, rest_edges_);
}

}  // namespace ease
