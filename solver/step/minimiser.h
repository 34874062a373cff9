// What the minimisers of the incremental potential share: when to stop, how far to go, what they report.
//
//   error = |x - x_min|_M / min(|x - x_n|_M, 4 |x - x_n - h v_n|_M)      relative error of a step
//
//   x_min        minimum of the potential, m
//   |d|_M        norm by the masses: sqrt(sum_i m_i |d_i|^2)
//   x_n + h v_n  where the step would end without forces, m
//
// The second length keeps free fall from counting as converged: cloth that falls fast moves far before any iteration.
// Newton's correction estimates x_min - x directly.  Other methods' corrections are shorter, most of all along soft
// directions; they are measured by their decrement sqrt(-g . d).  For Newton's d the decrement is the distance to the
// minimum in the norm of the Hessian, an upper bound of |d|_M / h.
#pragma once

#include <vector>

#include "solver/step/incremental_potential.h"

namespace ease {

struct StopRule {
  int max_iterations = 1;
  double error = 0.0;               // tolerance of the relative error above; 0: not checked
  double acceleration = 0.0;        // m/s^2: largest |dE/dx_i| / m_i of a vertex that is not pinned
  int patience = 0;                 // stop if the rate predicts more iterations than this; 0: never
  bool run_all_iterations = false;  // do not stop early; `converged` still says whether the tolerance was met
};

struct MinimiserSummary {
  int iterations = 0;
  int cg_iterations = 0;
  int factorisations = 0;
  int halvings = 0;  // times that a correction was halved since it raised the potential
  bool converged = false;
};

/// Positions with the potential, its gradient and how far the step moves the cloth there; pinned vertices have gradient
/// zero.
struct Point {
  Positions x, gradient;
  double energy = 0.0;
  StepMotion motion;
  void evaluate(IncrementalPotential& potential, const std::vector<char>& fixed);
};

/// Largest |dE/dx_i| / m_i, m/s^2.
double residualAcceleration(const IncrementalPotential& potential, const Point& point);

/// Decrement sqrt(-slope) over the error's denominator above; slope = gradient . direction, J.
double relativeDecrement(const IncrementalPotential& potential, const Point& point, double slope);

/// |direction|_M over the error's denominator above.
double relativeLength(const IncrementalPotential& potential, const Point& point, const Positions& direction);

/// Sets the mean of a correction, weighted by mass, to what momentum alone determines where no vertex is pinned and
/// nothing is near to touch:
///   sum_i m_i d_i = -h^2 sum_i dE/dx_i
/// since the cloth's own forces cancel in that sum.  In long steps inertia is so small beside these forces that the
/// round-off of a single-precision factor would otherwise move the whole cloth by metres.  Returns the change of the
/// slope gradient . direction, J.
double setMeanMotion(const IncrementalPotential& potential, const std::vector<char>& fixed, const Point& point,
                     Positions& direction);

/// Backtracking line search: tries direction, 1/2 direction, 1/4 direction ... until the potential decreases enough,
/// and writes that point to `next`; slope = gradient . direction, J.  Where the change of the potential is below
/// round-off, it accepts a point whose slope has become flatter instead.  Returns the number of halvings, or -1: no
/// decrease.
int searchAlong(IncrementalPotential& potential, const std::vector<char>& fixed, const Point& point,
                const Positions& direction, double slope, Point& next);

}  // namespace ease
