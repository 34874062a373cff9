// A symmetric matrix that couples every vertex of a mesh with its neighbours, gathered from blocks of its triangles.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/linear/cholesky.h"
#include "solver/mesh/triangle_gradient.h"

namespace ease {

class VertexMatrix {
 public:
  /// Orders and analyses the pattern once for all values.
  VertexMatrix(int vertices, const Triangles& triangles);

  void clear() { matrix_.coeffs().setZero(); }
  void addDiagonal(int vertex, double value) { matrix_.valuePtr()[diagonal_[vertex]] += value; }
  /// Adds a symmetric 3x3 block to the corners of triangle t.
  void add(int t, const Mat3& block);
  /// Rows and columns of these vertices become those of the identity.
  void fix(std::span<const char> fixed);

  /// Factors the matrix; returns false where it is not positive definite.
  [[nodiscard]] bool factor() { return cholesky_.factor(matrix_); }
  /// Solves A x = b in place, for as many columns of n values as `x` holds.  Not from several threads at a time.
  void solve(std::span<double> x) const;

 private:
  SparseMatrix matrix_;
  Cholesky cholesky_;
  std::vector<std::array<int, 9>> slots_;  // of corners p, q of triangle t, by 3 p + q; -1 above the diagonal
  std::vector<int> diagonal_;
};

/// Stiffness of the linear functions on a flat triangle: area times the products of their gradients.
inline Mat3 stiffnessBlock(const Mat2& rest_edges) {
  const Mat32 b = shapeGradients(rest_edges.inverse());
  return 0.5 * rest_edges.determinant() * b * b.transpose();
}

}  // namespace ease
