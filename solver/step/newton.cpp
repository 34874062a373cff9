#include "solver/step/newton.h"

#include <algorithm>

#include "solver/base/error.h"
#include "solver/linear/dot.h"

namespace ease {

namespace {

constexpr double kLinearTolerance = 1e-2;  // of a Newton correction: well below the error of stopping after one
constexpr double kMostGain = 0.5;          // of a correction over the one before, that is believed to go on
// A correction is up to 1 + this times the iterations of the last solve as long as what the factor makes of the
// residual, nineteen times in twenty.
constexpr double kUnseen = 0.5;
constexpr int kProjectedSteps = 2;  // iterations before the exact Hessian is tried (again)

}  // namespace

Newton::Newton(const Cloth& cloth, std::span<const int> ordering)
    : hessian_(cloth.vertexCount(), cloth.topology().edges), system_(hessian_, ordering) {}

bool Newton::direct(IncrementalPotential& potential, Curvature kind, const Point& point, MinimiserSummary& summary) {
  potential.hessian(point.x, kind, hessian_);
  const SolveSummary solve = system_.solve(
      hessian_, [&](const Positions& d, Positions& product) { potential.addBending(d, product); }, fixed_,
      -point.gradient, kLinearTolerance, direction_);
  summary.cg_iterations += solve.iterations;
  summary.factorisations += solve.factorisations;
  return solve.ok;
}

MinimiserSummary Newton::minimise(IncrementalPotential& potential, const std::vector<char>& fixed, const StopRule& stop,
                                  Point& point) {
  MinimiserSummary summary;
  if (fixed != fixed_) system_.forgetFactor();
  fixed_ = fixed;
  int exact_from = kProjectedSteps;
  double previous = 0.0;  // relative length of the last correction
  while (summary.iterations < stop.most_iterations) {
    if (stop.acceleration > 0.0 && residualAcceleration(potential, point) <= stop.acceleration) {
      summary.converged = true;
      break;
    }
    bool ok = false;
    if (summary.iterations >= exact_from) {
      ok = direct(potential, Curvature::exact, point, summary);
      if (!ok) exact_from = summary.iterations + kProjectedSteps;
    }
    if (!ok) ok = direct(potential, Curvature::projected, point, summary);
    ++summary.iterations;
    if (!ok) throw ComputationError("the linear system of the step is not positive definite");
    setMeanMotion(potential, fixed, point, direction_);
    const double slope = dot(point.gradient, direction_), length = relativeLength(potential, point, direction_);
    const int halvings = searchAlong(potential, fixed, point, direction_, slope, next_);
    if (halvings < 0) {
      const bool lost = -slope <= potential.roundOff(point.energy, point.motion);  // the promised decrease, in rounding
      if (!lost) throw ComputationError("no decrease of the potential along the step");
      break;
    }
    summary.halvings += halvings;
    std::swap(point, next_);
    // What the next correction is likely to be.
    double next = length;
    if (halvings == 0 && previous > 0.0) next *= std::clamp(length / previous, kMostGain, 1.0);
    previous = length;
    if (stop.error > 0.0 && next > stop.error && (stop.all || system_.factorIsNear())) {
      const Positions& d = system_.precondition(-point.gradient);
      const double unseen = 1.0 + kUnseen * system_.lastIterations();
      next = std::min(next, unseen * relativeLength(potential, point, d));
    }
    if (stop.error > 0.0 && next <= stop.error) {
      summary.converged = true;
      if (!stop.all) break;
    }
  }
  return summary;
}

}  // namespace ease
