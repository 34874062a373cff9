// Quadratic bending as a matrix. It is constant as long as the rest shape is, and each coordinate x, y, z uses the same
// matrix.
//
//   1/2 sum_hinges w |sum_i K_i x_i|^2 = 1/2 xᵀ Q x,   Q = sum_hinges w K Kᵀ      n x n, N/m (hinge.h, bending.h)
//
// The matrix couples a vertex with its second ring of neighbours, and bending is weak compared with the membrane.
// Solvers therefore only multiply with it and never factor it.
#pragma once

#include <vector>

#include "solver/model/hinge.h"

namespace ease {

class BendingMatrix {
 public:
  /// Builds the sparsity pattern. set() must be called with hinges of the same mesh, in the same order.
  BendingMatrix(int vertices, const std::vector<Hinge>& hinges);

  /// Computes the entries for hinges of bending stiffness D = `stiffness`, N m.
  void set(const std::vector<Hinge>& hinges, double stiffness);

  bool empty() const { return values_.empty(); }

  /// Adds row i of Q x, N, to `product`:  (Q x)_i = sum_j Q_ij (x_j - x_i),  because each row of Q sums to zero.
  /// Differences of positions have less round-off than positions.
  void addRow(int i, const Positions& x, Vec3& product) const {
    const Vec3 x_i = x.row(i);
    for (int k = start_[i]; k < start_[i + 1]; ++k) product += values_[k] * (x.row(column_[k]).transpose() - x_i);
  }

  /// Estimates the round-off in the bending energy, the sum over all rows, J.
  double roundOff(const Positions& x) const;

  /// Sum of |Q_ij| over j, N/m. The diagonal matrix of these sums is an upper bound of Q.
  double rowBound(int i) const;

 private:
  std::vector<int> start_, column_;  // compressed rows: row i has the entries start_[i] to start_[i + 1] - 1
  std::vector<double> values_;       // N/m
  std::vector<int> slots_;           // index in values_ for corners p, q of hinge h: slots_[16 h + 4 p + q]
};

}  // namespace ease
