// What the minimisers of the incremental potential share: when to stop, how far to go, what they report.
//
// The error of a step is what is left of the way to the minimum, |x - x_min|_M / h in the norm of the masses, over how
// far the step moves the cloth, |x - x_n|_M / h, or over four times what forces add to that motion,
// |x - x_n - h v_n|_M / h, where that is less: compared with the motion alone, cloth that falls fast enough would be
// done before it starts.  Newton's correction d is that way itself.  Other corrections are shorter than the way, along
// soft directions most of all; they are measured by their decrement sqrt(-g . d), which for Newton's d is the way in
// the energy's own norm and no less than in that of the masses.
#pragma once

#include <vector>

#include "solver/step/incremental_potential.h"

namespace ease {

struct StopRule {
  int most_iterations = 1;
  double error = 0.0;         // of the step, relative; 0: not looked at
  double acceleration = 0.0;  // m/s^2: largest |dE/dx_i| / m_i of a vertex that is not pinned
  int patience = 0;           // stop where more iterations than this seem to be left; 0: never
  bool all = false;           // go on to most_iterations; the rest says whether that was enough
};

struct MinimiserSummary {
  int iterations = 0;
  int cg_iterations = 0;
  int factorisations = 0;
  int halvings = 0;  // of a correction that would have raised the potential
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

/// sqrt(-slope) over how far the step moves the cloth, as above; slope = gradient . direction, J.
double relativeDecrement(const IncrementalPotential& potential, const Point& point, double slope);

/// |direction|_M over how far the step moves the cloth, as above.
double relativeLength(const IncrementalPotential& potential, const Point& point, const Positions& direction);

/// Sets the mean of a correction, weighted by mass, to what momentum alone determines where no vertex is pinned and
/// nothing is near to touch:
///   sum_i m_i d_i = -h^2 sum_i dE/dx_i
/// since the cloth's own forces cancel in that sum.  In long steps inertia is so small beside these forces that the
/// round-off of a single-precision factor would otherwise move the whole cloth by metres.  Returns the change of the
/// slope gradient . direction, J.
double setMeanMotion(const IncrementalPotential& potential, const std::vector<char>& fixed, const Point& point,
                     Positions& direction);

/// Goes from `point` along `direction` (all of it, or half, or a quarter ...) until the potential is less, and writes
/// where it arrives to `next`; slope = gradient . direction, J.  Close to the minimum, where the potential's decrease
/// is lost in rounding, the slope tells.  Returns the number of halvings, or -1: no decrease.
int searchAlong(IncrementalPotential& potential, const std::vector<char>& fixed, const Point& point,
                const Positions& direction, double slope, Point& next);

}  // namespace ease
