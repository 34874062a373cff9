// Quadratic bending as a matrix: constant between rest shapes, the same for every coordinate.
//
//   1/2 sum_hinges w |sum_i K_i x_i|^2 = 1/2 xᵀ Q x,   Q = sum_hinges w K Kᵀ      n x n, N/m (hinge.h, bending.h)
//
// It reaches to the second ring of a vertex and is weak beside the membrane: it is multiplied with, never factored.
#pragma once

#include <vector>

#include "solver/model/hinge.h"

namespace ease {

class BendingMatrix {
 public:
  /// The pattern; hinges must stay those of the same mesh.
  BendingMatrix(int vertices, const std::vector<Hinge>& hinges);

  /// Numbers for hinges of `stiffness` D (N m).
  void set(const std::vector<Hinge>& hinges, double stiffness);

  bool empty() const { return values_.empty(); }

  /// Row i of Q x, N.
  Vec3 row(int i, const Positions& x) const {
    Vec3 sum = Vec3::Zero();
    for (int k = start_[i]; k < start_[i + 1]; ++k) sum += values_[k] * x.row(column_[k]).transpose();
    return sum;
  }

 private:
  std::vector<int> start_, column_;
  std::vector<double> values_;  // N/m
  std::vector<int> slots_;      // of hinge h, corners p, q: slots_[16 h + 4 p + q]
};

}  // namespace ease
