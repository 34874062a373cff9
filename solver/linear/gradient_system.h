// Linear system for the vertex positions whose triangle gradients are nearest to given targets.
//
//   minimise over x (n x 3)   sum_t w_t |F_t(x) - T_t|^2  +  sum_i m_i |x_i - y_i|^2  +  sum_b k_b |x_p - x_q - d_b|^2
//
//   F_t = [x1 - x0, x2 - x0] D_t^-1   3x2 gradient of triangle t with respect to its flat coordinates
//   D_t                               2x2 edges of the triangle in its plane, m
//   T_t                               target gradient of triangle t, 3x2
//   y_i                               anchor of vertex i, m
//   w_t, m_i                          weights of targets and anchors
//   k_b, d_b                          weight and target of bond b, which joins vertices p and q of an edge, m
//
// The matrix A is a weighted cotangent Laplacian plus a diagonal. It is n x n and symmetric, positive definite if every
// connected part has some m_i > 0, and has three right-hand sides. Four algorithms use this system: the global step of
// projective dynamics (Bouaziz et al. 2014), the stitcher of adapted triangles (Sorkine and Alexa 2007), the
// interpolation of poses (Sumner and Popovic 2004) and the flattening of pattern pieces, which alone has bonds.
// Different weights along warp and weft are put into the columns of D^-1.
//
// The stitcher and the interpolation use a simplicial factor in double precision, which is faster to compute.
// Projective dynamics solves about ten times per step and uses panels (panels.h), which are faster to solve with.
// Milliseconds for 10,000 vertices on one thread:
//
//            simplicial   supernodal, panels
//   factor   9.6          15
//   solve    0.68         0.60 (0.35 on two threads)
//
// Tried and dropped:
// - The stitcher with the factor of projective dynamics. At 4,271 vertices it takes 11 to 14 iterations on panels and
//   3.4 ms instead of 10 iterations and 5.5 ms; with L-BFGS and either factor, 6 iterations and 2.0 ms. The time of a
//   whole run changes by less than 1 %.
// - Updates of the factor by CHOLMOD when contacts begin or end. If 170 of 1,100, 380 of 4,271 or 500 of 10,000
//   vertices change, an update takes as long as a new factor; contacts need only 13 new factors in 480 steps.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/linear/cholesky.h"
#include "solver/linear/incidence.h"
#include "solver/mesh/triangle_gradient.h"

namespace ease {

/// Makes the pattern of the matrix that couples each vertex with itself and its neighbours: lower triangle, all values
/// zero.
SparseMatrix vertexPattern(int vertices, const Triangles& triangles);

/// Computes an elimination order of a mesh's vertices that keeps factors sparse (METIS). All systems on the mesh can
/// use it.
std::vector<int> systemOrdering(int vertices, const Triangles& triangles);

/// Asks that two vertices, which share an edge of the mesh, differ by a given vector.
struct Bond {
  int p, q;
  double weight;
};

class GradientSystem {
 public:
  /// Analyses the mesh's connectivity. `ordering` is systemOrdering() of the mesh; if empty, it is computed.
  GradientSystem(int vertices, const Triangles& triangles, std::span<const int> ordering = {},
                 Cholesky::Kind kind = Cholesky::Kind::kSimplicial);

  /// Sets the bonds that factor() puts into the matrix; there are none before.
  void setBonds(std::span<const Bond> bonds);

  /// Computes the matrix from D_t^-1, w_t and m_i and factors it; returns false if it is not positive definite. Rows of
  /// `fixed` vertices become those of the identity; if `fixed` is empty, there are none.
  [[nodiscard]] bool factor(std::span<const Mat2> rest_inverse, std::span<const double> weights,
                            std::span<const double> diagonal, std::span<const char> fixed = {});

  /// Computes the positions x for one target T_t per triangle; `anchors` are the y_i, `bond_targets` the d_b.
  void solve(std::span<const Mat32> targets, const Positions& anchors, Positions& x,
             std::span<const Vec3> bond_targets = {});

  /// Solves A x = right in single precision; x may be `right`.  Only for supernodal systems.
  void solveRounded(const Positions& right, Positions& x);

 private:
  int slot(int i, int j) const;

  Triangles triangles_;
  Incidence incidence_;
  SparseMatrix matrix_;
  Cholesky cholesky_;
  Cholesky::Kind kind_;
  Panels panels_;
  std::vector<std::array<int, 9>>
      slots_;  // index in the matrix's values of corners p, q of triangle t, by 3 p + q; -1 above the diagonal
  std::vector<int> diagonal_slots_;
  std::vector<Mat32> weighted_gradients_;  // w_t times the gradients of the three shape functions
  std::vector<double> diagonal_;
  std::vector<Bond> bonds_;
  Eigen::MatrixX3d right_;  // stored by columns, as the factor expects them
};

}  // namespace ease
