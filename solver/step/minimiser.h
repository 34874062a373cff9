// Parts that the minimisers of the incremental potential share: stopping rule, line search and summary.
//
//   error^2 = |x - x_min|^2_M / (min(|x - x_n|_M, 4 |x - x_n - h v_n|_M)^2 + m (h v_min)^2)    of a step, relative
//
//   m, v_min     mass of the cloth, kg, and 1 mm/s; with this term cloth at rest converges
//   x_min        positions that minimise the potential, m
//   x_n          positions at the start of the step, m
//   |d|_M        norm weighted by the masses: sqrt(sum_i m_i |d_i|^2)
//   x_n + h v_n  end of the step if there were no forces, m
//
// Without the second length, cloth that falls fast would count as converged at once: its motion |x - x_n| is large
// before any iteration.
//
// Newton's correction estimates x_min - x directly. The corrections of the other methods are shorter, most of all along
// soft directions, so these methods use the decrement sqrt(-g . d) instead (gradient g, correction d). For Newton's d
// the decrement is the distance to the minimum in the norm of the Hessian, an upper bound of |d|_M / h.
#pragma once

#include <vector>

#include "solver/step/incremental_potential.h"

namespace ease {

/// Limits and tolerances at which a minimiser stops.
struct StopRule {
  int max_iterations = 1;
  double error = 0.0;               // tolerance of the relative error above; 0: not checked
  double acceleration = 0.0;        // m/s^2: largest |dE/dx_i| / m_i of a vertex that is not pinned; 0: not checked
  int patience = 0;                 // stop if the rate predicts more iterations than this; 0: never
  bool run_all_iterations = false;  // do not stop early; `converged` still says whether the tolerance was met
  int max_cg_iterations = 0;        // Newton stops after this many iterations of conjugate gradients in all; 0: never
};

/// Counts of the work in one minimisation.
struct MinimiserSummary {
  int iterations = 0;
  int cg_iterations = 0;
  int factorisations = 0;
  int halvings = 0;  // number of times a correction was halved because it did not lower the potential enough
  bool converged = false;
};

/// Positions, and the potential, its gradient and the motion of the step at these positions. The gradient is zero at
/// pinned vertices.
struct Point {
  Positions x, gradient;
  double energy = 0.0;
  StepMotion motion;
  void evaluate(IncrementalPotential& potential, const std::vector<char>& fixed);
};

/// Largest |dE/dx_i| / m_i over all vertices, m/s^2; zero gradient counts for pinned vertices.
double residualAcceleration(const IncrementalPotential& potential, const Point& point);

/// Decrement sqrt(-slope) times h, divided by the error's denominator (see above); slope = gradient . direction, J.
double relativeDecrement(const IncrementalPotential& potential, const Point& point, double slope);

/// |direction|_M divided by the error's denominator (see above).
double relativeLength(const IncrementalPotential& potential, const Point& point, const Positions& direction);

/// Corrects the mean of a correction, weighted by mass, to the value that follows from momentum:
///   sum_i m_i d_i = -h^2 sum_i dE/dx_i
/// This holds because the cloth's inner forces cancel in the sum. In long steps inertia is small beside these forces,
/// and the round-off of a single-precision factor would otherwise move the whole cloth by metres. Does nothing if a
/// vertex is pinned or the cloth may touch something. Returns the change of the slope gradient . direction, J.
double setMeanMotion(const IncrementalPotential& potential, const std::vector<char>& fixed, const Point& point,
                     Positions& direction);

/// Backtracking line search: tries direction, 1/2 direction, 1/4 direction ... until the potential decreases enough,
/// and writes that point to `next`; slope = gradient . direction, J.  Where the change of the potential is below
/// round-off, it accepts a point at which the slope is flatter instead. Returns the number of halvings, or -1 if no
/// point was accepted.
int searchAlong(IncrementalPotential& potential, const std::vector<char>& fixed, const Point& point,
                const Positions& direction, double slope, Point& next);

}  // namespace ease
