// Newton's method on the incremental potential.
//
// Far from the minimum every element's Hessian is projected to be positive (Teran 2005).  Where cloth is compressed
// that converges linearly only (a rate of .8 was met: fifty iterations for five digits): after two iterations the exact
// Hessian is used, as long as conjugate gradients meet no negative curvature.
//
// One iteration from x_n + h v_n is the Baraff-Witkin step (`bw1`): they linearise at x_n, but from there the same work
// leaves seven times the error.
#pragma once

#include "solver/step/minimiser.h"
#include "solver/step/newton_system.h"

namespace ease {

class Newton {
 public:
  /// `ordering`: of the mesh's systems (gradient_system.h).
  Newton(const Cloth& cloth, std::span<const int> ordering);

  /// Iterates from `point`, evaluated, and leaves it evaluated.  Throws ComputationError where a system cannot be
  /// solved or nothing lowers the potential though it is far from its minimum.
  MinimiserSummary minimise(IncrementalPotential& potential, const std::vector<char>& fixed, const StopRule& stop,
                            Point& point);

  /// Makes the next minimise() independent of earlier ones.
  void forget() { system_.forgetFactor(); }

 private:
  bool solveForDirection(IncrementalPotential& potential, HessianKind kind, const Point& point,
                         MinimiserSummary& summary);

  BlockMatrix hessian_;
  NewtonSystem system_;
  std::vector<char> fixed_;
  Positions direction_;
  Point next_;
};

}  // namespace ease
