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

  /// Adds row i of Q x, N, to `product`, and returns the row's share of 1/2 xᵀ Q x, J.  Rows of Q add up to zero, so
  /// that it sees differences alone, where rounding is least: (Q x)_i = sum_j Q_ij (x_j - x_i), and the share is
  /// -1/4 sum_j Q_ij |x_j - x_i|^2.
  double addRow(int i, const Positions& x, Vec3& product) const {
    const Vec3 here = x.row(i);
    double energy = 0.0;
    for (int k = start_[i]; k < start_[i + 1]; ++k) {
      const Vec3 apart = x.row(column_[k]).transpose() - here;
      product += values_[k] * apart;
      energy -= values_[k] * apart.squaredNorm();
    }
    return 0.25 * energy;
  }

  /// What rounding may do to the energy of all rows, J.
  double roundOff(const Positions& x) const;

  /// Sum of |Q_ij| over j, N/m: a diagonal of these bounds Q.
  double rowBound(int i) const;

 private:
  std::vector<int> start_, column_;
  std::vector<double> values_;  // N/m
  std::vector<int> slots_;      // of hinge h, corners p, q: slots_[16 h + 4 p + q]
};

}  // namespace ease
