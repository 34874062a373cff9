#include "solver/step/bending_matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/base/parallel.h"

namespace ease {

BendingMatrix::BendingMatrix(int vertices, const std::vector<Hinge>& hinges) : start_(vertices + 1, 0) {
  if (hinges.empty()) return;
  std::vector<std::vector<int>> columns(vertices);
  for (const Hinge& hinge : hinges)
    for (int i : hinge.vertices) columns[i].insert(columns[i].end(), hinge.vertices.begin(), hinge.vertices.end());
  for (int i = 0; i < vertices; ++i) {
    std::sort(columns[i].begin(), columns[i].end());
    columns[i].erase(std::unique(columns[i].begin(), columns[i].end()), columns[i].end());
    column_.insert(column_.end(), columns[i].begin(), columns[i].end());
    start_[i + 1] = static_cast<int>(column_.size());
  }
  values_.resize(column_.size());
  for (const Hinge& hinge : hinges)
    for (int i : hinge.vertices)
      for (int j : hinge.vertices)
        slots_.push_back(static_cast<int>(
            std::lower_bound(column_.begin() + start_[i], column_.begin() + start_[i + 1], j) - column_.begin()));
}

void BendingMatrix::set(const std::vector<Hinge>& hinges, double stiffness) {
  std::fill(values_.begin(), values_.end(), 0.0);
  for (size_t h = 0; h < hinges.size(); ++h) {
    const double w = stiffness * hinges[h].inverse_area;
    for (int p = 0; p < 4; ++p)
      for (int q = 0; q < 4; ++q)
        values_[slots_[16 * h + 4 * p + q]] += w * hinges[h].stencil[p] * hinges[h].stencil[q];
  }
}

double BendingMatrix::roundOff(const Positions& x) const {
  if (empty()) return 0.0;
  const double magnitude = parallelSum(static_cast<int>(x.rows()), [&](int i) {
    double sum = 0.0;
    for (int k = start_[i]; k < start_[i + 1]; ++k)
      sum += std::abs(values_[k]) * (x.row(column_[k]) - x.row(i)).squaredNorm();
    return 0.25 * sum;
  });
  return 8.0 * std::numeric_limits<double>::epsilon() * magnitude;
}

double BendingMatrix::rowBound(int i) const {
  double sum = 0.0;
  if (empty()) return sum;
  for (int k = start_[i]; k < start_[i + 1]; ++k) sum += std::abs(values_[k]);
  return sum;
}

}  // namespace ease
