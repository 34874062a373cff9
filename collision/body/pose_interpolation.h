// The poses between two, many of them: a polynomial in s through a few that are solved for (gradient_interpolation.h).
//
//   x(s)   vertices at s in [0, 1], m
//   s_j    sin^2(j pi / 2n), j = 0..n: Chebyshev points of the second kind, the ends among them
//   theta  largest turn of a triangle, radians
//
// The gradients' targets exp(s log R) ((1 - s) I + s S) are analytic in s and the solve is linear, so x(s) is analytic
// too, and the polynomial of degree n through x(s_j) is all but x(s).  Its error is at most twice the Chebyshev
// coefficients that it leaves out.  Those of exp(i theta s) are 2 |J_k(theta / 2)| <= 2 (theta / 4)^k / k!, and the
// linear factor raises degrees by one: the error is of the order of 2 (theta / 4)^n / n! times the size of the body.
// n is the least for which that is below a ten-billionth: 13 for a turn of 180 degrees, 17 for 360.
//
// The polynomial is evaluated by the barycentric formula (Berrut and Trefethen 2004).  At a node it is the node's pose,
// to the last bit: a motion that ends there and one that goes on are the same.
//
// Milliseconds for a scanned body of 27,578 vertices, one thread, n = 13: a pose .3 to .7 as caches are warm or cold,
// one that is solved for 4.8; set-up 138, of which the solves are 60.  It pays from some 14 poses on.
#pragma once

#include <span>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

class PoseInterpolation {
 public:
  /// Solves for n - 1 poses.  `ordering`: of the body's systems, or empty.  Throws ComputationError.
  PoseInterpolation(const Triangles& triangles, const Positions& from, const Positions& to,
                    std::span<const int> ordering = {});

  /// The body at s in [0, 1], m; `from` and `to` themselves at the ends.
  void at(double s, Positions& x) const;

 private:
  std::vector<double> points_;    // s_j
  std::vector<Positions> poses_;  // x(s_j), m
};

}  // namespace ease
