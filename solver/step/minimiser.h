// What the minimisers of the incremental potential share: when to stop, how far to go, what they report.
//
// The error of a step is measured by its decrement, sqrt(-g . d) with d the correction that a minimiser is about to
// make: for Newton's method the distance to the minimum in the energy's own norm.  It is compared with how far the step
// moves the cloth in the norm of its masses, |x - x_n|_M / h, which that norm bounds from above, or with four times
// what forces add to that motion, |x - x_n - h v_n|_M / h, where that is less: compared with the motion alone, cloth
// that falls fast enough would be done before it starts.
#pragma once

#include <vector>

#include "solver/step/incremental_potential.h"

namespace ease {

struct StopRule {
  int most_iterations = 1;
  double error = 0.0;         // of the step, relative; 0: not looked at
  double acceleration = 0.0;  // m/s^2: largest |dE/dx_i| / m_i of a vertex that is not pinned
  int patience = 0;           // stop where more iterations than this seem to be left; 0: never
};

struct MinimiserSummary {
  int iterations = 0;
  int cg_iterations = 0;
  int factorisations = 0;
  int halvings = 0;  // of a correction that would have raised the potential
  bool converged = false;
};

/// Positions with the potential and its gradient there; pinned vertices have gradient zero.
struct Point {
  Positions x, gradient;
  double energy = 0.0;
  void evaluate(IncrementalPotential& potential, const std::vector<char>& fixed);
};

/// Largest |dE/dx_i| / m_i, m/s^2.
double residualAcceleration(const IncrementalPotential& potential, const Point& point);

/// sqrt(-slope) over how far the step moves the cloth, as above; slope = gradient . direction, J.
double relativeDecrement(const IncrementalPotential& potential, const Point& point, double slope);

/// Goes from `point` along `direction` (all of it, or half, or a quarter ...) until the potential is less, and writes
/// where it arrives to `next`.  Close to the minimum, where the potential's decrease is lost in rounding, the slope
/// tells.  Returns the number of halvings, or -1: no decrease.
int searchAlong(IncrementalPotential& potential, const std::vector<char>& fixed, const Point& point,
                const Positions& direction, Point& next);

}  // namespace ease
