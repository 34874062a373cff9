#include "solver/linear/gradient_system.h"

#include "solver/linear/parallel.h"

namespace ease {

SparseMatrix vertexPattern(int vertices, const Triangles& triangles) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(vertices + 3 * triangles.rows());
  for (int i = 0; i < vertices; ++i) entries.emplace_back(i, i, 0.0);
  for (int t = 0; t < triangles.rows(); ++t)
    for (int a = 0; a < 3; ++a) {
      const int i = triangles(t, a), j = triangles(t, (a + 1) % 3);
      entries.emplace_back(std::max(i, j), std::min(i, j), 0.0);
    }
  SparseMatrix lower(vertices, vertices);
  lower.setFromTriplets(entries.begin(), entries.end());
  lower.makeCompressed();
  return lower;
}

GradientSystem::GradientSystem(int vertices, const Triangles& triangles, std::span<const int> ordering)
    : triangles_(triangles),
      incidence_(vertices, {triangles_.data(), static_cast<size_t>(triangles_.size())}),
      matrix_(vertexPattern(vertices, triangles)),
      cholesky_(Cholesky::Kind::kSimplicial),
      right_(vertices, 3) {
  cholesky_.analyse(matrix_, ordering);
}

bool GradientSystem::factor(std::span<const Mat2> rest_inverse, std::span<const double> weights,
                            std::span<const double> diagonal) {
  diagonal_.assign(diagonal.begin(), diagonal.end());
  weighted_gradients_.resize(triangles_.rows());
  matrix_.coeffs().setZero();
  for (size_t i = 0; i < diagonal.size(); ++i) matrix_.coeffRef(i, i) = diagonal[i];
  for (int t = 0; t < triangles_.rows(); ++t) {
    const Mat32 b = shapeGradients(rest_inverse[t]);
    weighted_gradients_[t] = weights[t] * b;
    for (int p = 0; p < 3; ++p)
      for (int q = 0; q < 3; ++q)
        if (const int i = triangles_(t, p), j = triangles_(t, q); i >= j)
          matrix_.coeffRef(i, j) += weighted_gradients_[t].row(p).dot(b.row(q));
  }
  return cholesky_.factor(matrix_);
}

void GradientSystem::solve(std::span<const Mat32> targets, const Positions& anchors, Positions& x) {
  const int n = static_cast<int>(right_.rows());
  parallelFor(n, 512, [&](int i) {
    Vec3 sum = diagonal_[i] * anchors.row(i).transpose();
    for (int k : incidence_.of(i)) sum += targets[k / 3] * weighted_gradients_[k / 3].row(k % 3).transpose();
    right_.row(i) = sum;
  });
  cholesky_.solve(right_.data(), right_.data(), 3);
  x = right_;
}

}  // namespace ease
