// Newton's method on the incremental potential.
//
// In the first two iterations every element's Hessian is projected to be positive semi-definite (Teran 2005), which is
// safe far from the minimum. But where cloth is compressed, the projected Hessian converges only linearly: at the
// measured rate of 0.8, five digits take fifty iterations. Later iterations therefore use the exact Hessian, as long as
// conjugate gradients meet no negative curvature.
//
// One iteration from x_n + h v_n is the Baraff-Witkin step (`bw1`). Baraff and Witkin linearise at x_n, which leaves
// seven times the error for equal work.
#pragma once

#include "solver/step/minimiser.h"
#include "solver/step/newton_system.h"

namespace ease {

class Newton {
 public:
  /// `ordering`: elimination order of the vertices (gradient_system.h).
  Newton(const Cloth& cloth, std::span<const int> ordering);

  /// Iterates from `point`, which must be evaluated, and leaves it evaluated. Throws ComputationError if a linear
  /// system cannot be solved, or if the line search finds no decrease although the minimum is still far.
  MinimiserSummary minimise(IncrementalPotential& potential, const std::vector<char>& fixed, const StopRule& stop,
                            Point& point);

  /// Makes the next minimise() independent of earlier ones.
  void forget() { system_.forgetFactor(); }

 private:
  /// Solves for direction_ with the Hessian of this kind, in at most `max_cg_iterations`; returns whether it could be
  /// solved.
  bool solveForDirection(IncrementalPotential& potential, HessianKind kind, const Point& point, int max_cg_iterations,
                         MinimiserSummary& summary);

  BlockMatrix hessian_;
  NewtonSystem system_;
  std::vector<char> fixed_;
  Positions direction_;
  Point next_;
};

}  // namespace ease
