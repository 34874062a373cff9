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
// part has some m_i > 0), with three right-hand sides.  It serves the global step of projective dynamics (Bouaziz et
// al. 2014), the stitcher of adapted triangles (Sorkine and Alexa 2007) and the interpolation of poses (Sumner and
// Popovic 2004).  Weights that differ along warp and weft go into the columns of D^-1.
//
// Stitcher and interpolation use a simplicial factor, in double precision, which is faster to make.  Projective
// dynamics solves for corrections some ten times a step and takes panels (panels.h).  Milliseconds at 10,000 vertices,
// one thread: factor 9.6 simplicial, 15 supernodal; solve .68 simplicial, .60 panels (.35 with two threads).
//
// Tried and dropped: the stitcher on projective dynamics' own factor (11 to 14 iterations for its 10, of
// panels: 3.4 ms for 5.5 at 4,271 vertices; with L-BFGS, on either's factor, 6 iterations and 2.0 ms; a run of the main
// job is as fast to a hundredth with any of them).  CHOLMOD's update of a factor where contacts come and go: as long as
// a new factor for 170, 380, 500 vertices of 1,100, 4,271, 10,000, while contacts ask for 13 factors in 480 steps.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/linear/cholesky.h"
#include "solver/linear/incidence.h"
#include "solver/mesh/triangle_gradient.h"

namespace ease {

/// Makes the lower triangle, all zero, of the matrix that couples each vertex with itself and its neighbours.
SparseMatrix vertexPattern(int vertices, const Triangles& triangles);

/// Orders a mesh's vertices so that factors stay sparse (METIS); one ordering serves all systems on the mesh.
std::vector<int> systemOrdering(int vertices, const Triangles& triangles);

class GradientSystem {
 public:
  /// Analyses the mesh's connectivity.  `ordering`: systemOrdering() of the mesh, or empty to compute it here.
  GradientSystem(int vertices, const Triangles& triangles, std::span<const int> ordering = {},
                 Cholesky::Kind kind = Cholesky::Kind::kSimplicial);

  /// Sets the matrix's values and factors it; returns false if it is not positive definite.  Rows of `fixed` vertices
  /// (none if empty) become those of the identity.
  [[nodiscard]] bool factor(std::span<const Mat2> rest_inverse, std::span<const double> weights,
                            std::span<const double> diagonal, std::span<const char> fixed = {});

  /// Computes the positions x for one target T_t per triangle; `anchors` are the y_i.
  void solve(std::span<const Mat32> targets, const Positions& anchors, Positions& x);

  /// Solves A x = right in single precision; x may be `right`.  Only for supernodal systems.
  void solveRounded(const Positions& right, Positions& x);

 private:
  Triangles triangles_;
  Incidence incidence_;
  SparseMatrix matrix_;
  Cholesky cholesky_;
  Cholesky::Kind kind_;
  Panels panels_;
  std::vector<std::array<int, 9>>
      slots_;  // where corners p, q of triangle t stand in the values; -1 above the diagonal
  std::vector<int> diagonal_slots_;
  std::vector<Mat32> weighted_gradients_;  // w_t B_t
  std::vector<double> diagonal_;
  Eigen::MatrixX3d right_;  // stored by columns, as the factor expects them
};

}  // namespace ease
