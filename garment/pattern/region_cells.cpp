#include "garment/pattern/region_cells.h"

#include <Eigen/LU>

#include <algorithm>

namespace ease {
namespace {

Vec3 levelsAt(const RegionLevels& levels, const std::array<int, 3>& corners, int label) {
  const double* phi = levels.of(label);
  return {phi[corners[0]], phi[corners[1]], phi[corners[2]]};
}

}  // namespace

void Cells::find(const RegionLevels& levels, const Triangles& triangles, int t) {
  const std::array<int, 3> corners = {triangles(t, 0), triangles(t, 1), triangles(t, 2)};
  labels_.clear();
  for (int k = 0; k < levels.labels; ++k) {
    const Vec3 own = levelsAt(levels, corners, k);
    bool is_above = false;  // another level everywhere
    for (int j = 0; j < levels.labels && !is_above; ++j)
      if (j != k) {
        const Vec3 other = levelsAt(levels, corners, j);
        is_above = (other.array() <= own.array()).all() && (j < k || other != own);
      }
    if (!is_above) labels_.push_back(k);
  }
  count_ = 0;
  if (cells_.size() < labels_.size()) cells_.resize(labels_.size());
  for (const int label : labels_) {
    Cell& cell = cells_[count_];
    cell.label = label;
    cell.points.clear();
    for (int k = 0; k < 3; ++k) cell.points.push_back({Vec3::Unit(k), {(k + 1) % 3, (k + 2) % 3}, (k + 2) % 3});
    for (const int other : labels_)
      if (other != label && !cell.points.empty()) clip(levels, corners, other, cell);
    if (cell.points.size() > 2) ++count_;
  }
}

/// Keeps the part of a cell where its level is below that of another label.
void Cells::clip(const RegionLevels& levels, const std::array<int, 3>& corners, int other, Cell& cell) {
  const Vec3 gap = levelsAt(levels, corners, cell.label) - levelsAt(levels, corners, other);
  clipped_.clear();
  const size_t n = cell.points.size();
  for (size_t i = 0; i < n; ++i) {
    const CellPoint &a = cell.points[i], &b = cell.points[(i + 1) % n];
    const double at_a = gap.dot(a.beta), at_b = gap.dot(b.beta);
    if (at_a < 0.0) clipped_.push_back(a);
    if ((at_a < 0.0) == (at_b < 0.0)) continue;
    const double s = at_a / (at_a - at_b);
    const bool leaves = at_a < 0.0;  // the border goes on along the line
    clipped_.push_back({(1.0 - s) * a.beta + s * b.beta, {a.side, 3 + other}, leaves ? 3 + other : a.side});
  }
  std::swap(cell.points, clipped_);
}

void addByLevels(const RegionLevels& levels, const std::array<int, 3>& corners, int label, const CellPoint& point,
                 const Vec3& by_corner, std::vector<double>& derivative) {
  Mat3 meets;  // rows: what is 0 at the point, and the sum of its coordinates
  for (int i = 0; i < 2; ++i)
    meets.row(i) = point.on[i] < 3
                       ? Vec3(Vec3::Unit(point.on[i]))
                       : Vec3(levelsAt(levels, corners, label) - levelsAt(levels, corners, point.on[i] - 3));
  meets.row(2).setOnes();
  bool is_invertible = false;
  Mat3 inverse;
  double determinant = 0.0;
  meets.computeInverseAndDetWithCheck(inverse, determinant, is_invertible, 0.0);
  if (!is_invertible) return;  // two lines on each other: the point does not move with either
  const Vec3 y = inverse.transpose() * by_corner;
  const size_t n = levels.phi.size() / levels.labels;
  for (int i = 0; i < 2; ++i) {
    if (point.on[i] < 3) continue;
    for (int c = 0; c < 3; ++c) {
      derivative[label * n + corners[c]] -= y[i] * point.beta[c];
      derivative[(point.on[i] - 3) * n + corners[c]] += y[i] * point.beta[c];
    }
  }
}

}  // namespace ease
