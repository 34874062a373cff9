// The one linear system that several users share: vertex positions whose triangle gradients are nearest to given ones.
//
//   minimise over x (n x 3)   sum_t w_t |F_t(x) - T_t|^2  +  sum_i m_i |x_i - y_i|^2
//
//   F_t = [x1 - x0, x2 - x0] D_t^-1   3x2 gradient of triangle t with respect to its flat coordinates
//   D_t                               2x2 edges of the triangle in the plane, m
//   T_t                               target, 3x2
//   w_t, m_i                          weights, any unit, the same for both
//
// The matrix is a weighted cotangent Laplacian plus a diagonal (n x n, symmetric, positive definite if every connected
// part has some m_i > 0), with three right-hand sides: the stitcher of adapted triangles and the interpolation of poses
// solve it (Sumner and Popovic 2004; Sorkine and Alexa 2007).
#pragma once

#include <span>
#include <vector>

#include "solver/linear/cholesky.h"
#include "solver/linear/incidence.h"
#include "solver/mesh/triangle_gradient.h"

namespace ease {

/// Lower triangle, all zero, of the matrix that couples every vertex with itself and its neighbours.
SparseMatrix vertexPattern(int vertices, const Triangles& triangles);

class GradientSystem {
 public:
  /// Orders and analyses: once for a mesh's connectivity; systems on the same mesh take the ordering of the first.
  GradientSystem(int vertices, const Triangles& triangles, std::span<const int> ordering = {});
  std::vector<int> ordering() const { return cholesky_.ordering(); }

  /// Sets the numbers and factors.  False if not positive definite.
  [[nodiscard]] bool factor(std::span<const Mat2> rest_inverse, std::span<const double> weights,
                            std::span<const double> diagonal);

  /// Positions for these targets, one a triangle; `anchors` are the y_i.
  void solve(std::span<const Mat32> targets, const Positions& anchors, Positions& x);

 private:
  Triangles triangles_;
  Incidence incidence_;
  SparseMatrix matrix_;
  Cholesky cholesky_;
  std::vector<Mat32> weighted_gradients_;  // w_t B_t
  std::vector<double> diagonal_;
  Eigen::MatrixX3d right_;  // columns, as the factor takes them
};

}  // namespace ease
