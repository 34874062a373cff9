#include "solver/linear/gradient_system.h"

#include <algorithm>
#include <cassert>

#include "solver/base/parallel.h"

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

std::vector<int> systemOrdering(int vertices, const Triangles& triangles) {
  Cholesky cholesky(Cholesky::Kind::kSimplicial);
  cholesky.analyse(vertexPattern(vertices, triangles));
  return cholesky.ordering();
}

GradientSystem::GradientSystem(int vertices, const Triangles& triangles, std::span<const int> ordering,
                               Cholesky::Kind kind)
    : triangles_(triangles),
      incidence_(vertices, {triangles_.data(), static_cast<size_t>(triangles_.size())}),
      matrix_(vertexPattern(vertices, triangles)),
      cholesky_(kind),
      kind_(kind),
      right_(vertices, 3) {
  cholesky_.analyse(matrix_, ordering);
  slots_.resize(triangles.rows());
  for (int t = 0; t < triangles.rows(); ++t)
    for (int p = 0; p < 3; ++p)
      for (int q = 0; q < 3; ++q) {
        const int i = triangles(t, p), j = triangles(t, q);
        slots_[t][3 * p + q] = i >= j ? slot(i, j) : -1;
      }
  for (int i = 0; i < vertices; ++i) diagonal_slots_.push_back(slot(i, i));
}

/// Index in the matrix's values of entry (i, j), i >= j.
int GradientSystem::slot(int i, int j) const {
  const int *begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[j],
            *end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[j + 1];
  return static_cast<int>(std::lower_bound(begin, end, i) - matrix_.innerIndexPtr());
}

void GradientSystem::setBonds(std::span<const Bond> bonds) {
  bonds_.assign(bonds.begin(), bonds.end());
}

bool GradientSystem::factor(std::span<const Mat2> rest_inverse, std::span<const double> weights,
                            std::span<const double> diagonal, std::span<const char> fixed) {
  diagonal_.assign(diagonal.begin(), diagonal.end());
  weighted_gradients_.resize(triangles_.rows());
  double* values = matrix_.valuePtr();
  matrix_.coeffs().setZero();
  for (size_t i = 0; i < diagonal.size(); ++i) values[diagonal_slots_[i]] = diagonal[i];
  for (int t = 0; t < triangles_.rows(); ++t) {
    const Mat32 b = shapeGradients(rest_inverse[t]);
    weighted_gradients_[t] = weights[t] * b;
    const Mat3 block = weighted_gradients_[t] * b.transpose();
    for (int k = 0; k < 9; ++k)
      if (slots_[t][k] >= 0) values[slots_[t][k]] += block(k / 3, k % 3);
  }
  for (const Bond& bond : bonds_) {
    values[diagonal_slots_[bond.p]] += bond.weight;
    values[diagonal_slots_[bond.q]] += bond.weight;
    values[slot(std::max(bond.p, bond.q), std::min(bond.p, bond.q))] -= bond.weight;
  }
  if (!fixed.empty())
    for (int j = 0; j < matrix_.cols(); ++j)
      for (SparseMatrix::InnerIterator it(matrix_, j); it; ++it)
        if (fixed[j] || fixed[it.row()]) it.valueRef() = it.row() == j ? 1.0 : 0.0;
  if (!cholesky_.factor(matrix_)) return false;
  if (kind_ == Cholesky::Kind::kSupernodal) cholesky_.copyTo(panels_);
  return true;
}

void GradientSystem::solveRounded(const Positions& right, Positions& x) {
  assert(kind_ == Cholesky::Kind::kSupernodal);
  panels_.solve(right.data(), x.data(), 3);
}

void GradientSystem::solve(std::span<const Mat32> targets, const Positions& anchors, Positions& x,
                           std::span<const Vec3> bond_targets) {
  const int n = static_cast<int>(right_.rows());
  parallelFor(n, 512, [&](int i) {
    Vec3 sum = diagonal_[i] * anchors.row(i).transpose();
    for (int k : incidence_.of(i)) sum += targets[k / 3] * weighted_gradients_[k / 3].row(k % 3).transpose();
    right_.row(i) = sum;
  });
  assert(bond_targets.size() == bonds_.size());
  for (size_t b = 0; b < bonds_.size(); ++b) {
    const Vec3 pull = bonds_[b].weight * bond_targets[b];
    right_.row(bonds_[b].p) += pull;
    right_.row(bonds_[b].q) -= pull;
  }
  cholesky_.solve(right_.data(), right_.data(), 3);
  x = right_;
}

}  // namespace ease
