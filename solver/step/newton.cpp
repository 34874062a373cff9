#include "solver/step/newton.h"

#include <algorithm>
#include <limits>

#include "solver/base/error.h"
#include "solver/linear/dot.h"

namespace ease {

namespace {

constexpr double kLinearTolerance = 1e-2;  // relative; well below the error that remains after one Newton iteration
constexpr double kMinTrustedRatio = 0.5;   // predict the next correction by the last ratio, but at most halved
// error <= (1 + 0.5 iterations) |preconditioned residual| in 95 % of steps, where `iterations` are those of conjugate
// gradients in the last solve.
constexpr double kErrorPerIteration = 0.5;
constexpr int kProjectedSteps = 2;  // iterations with the projected Hessian before each trial of the exact one

}  // namespace

Newton::Newton(const Cloth& cloth, std::span<const int> ordering)
    : hessian_(cloth.vertexCount(), cloth.topology().edges), system_(hessian_, ordering) {}

bool Newton::solveForDirection(IncrementalPotential& potential, HessianKind kind, const Point& point,
                               int max_cg_iterations, MinimiserSummary& summary) {
  potential.hessian(point.x, kind, hessian_);
  const SolveSummary solve = system_.solve(
      hessian_, [&](const Positions& d, Positions& product) { potential.addBendingProduct(d, product); }, fixed_,
      -point.gradient, kLinearTolerance, direction_, max_cg_iterations);
  summary.cg_iterations += solve.iterations;
  summary.factorisations += solve.factorisations;
  return solve.ok;
}

MinimiserSummary Newton::minimise(IncrementalPotential& potential, const std::vector<char>& fixed, const StopRule& stop,
                                  Point& point) {
  MinimiserSummary summary;
  if (fixed != fixed_) system_.forgetFactor();
  fixed_ = fixed;
  const int max_cg_iterations = stop.max_cg_iterations > 0 ? stop.max_cg_iterations : std::numeric_limits<int>::max();
  int exact_from = kProjectedSteps;
  double previous = 0.0;  // relative length of the last correction
  while (summary.iterations < stop.max_iterations) {
    if (stop.acceleration > 0.0 && residualAcceleration(potential, point) <= stop.acceleration) {
      summary.converged = true;
      break;
    }
    const int cg_left = max_cg_iterations - summary.cg_iterations;
    bool ok = false;
    if (summary.iterations >= exact_from) {
      ok = solveForDirection(potential, HessianKind::exact, point, cg_left, summary);
      if (!ok) exact_from = summary.iterations + kProjectedSteps;
    }
    if (!ok) ok = solveForDirection(potential, HessianKind::projected, point, cg_left, summary);
    ++summary.iterations;
    if (!ok) throw ComputationError("the linear system of the step is not positive definite");
    setMeanMotion(potential, fixed, point, direction_);
    const double slope = dot(point.gradient, direction_), length = relativeLength(potential, point, direction_);
    const int halvings = searchAlong(potential, fixed, point, direction_, slope, next_);
    if (halvings < 0) {
      const bool lost =
          -slope <= potential.roundOff(point.energy, point.motion);  // the predicted decrease is below round-off
      if (!lost) throw ComputationError("no decrease of the potential along the step");
      break;
    }
    summary.halvings += halvings;
    std::swap(point, next_);
    if (summary.cg_iterations >= max_cg_iterations) break;
    // Predict the length of the next correction.
    double next = length;
    if (halvings == 0 && previous > 0.0) next *= std::clamp(length / previous, kMinTrustedRatio, 1.0);
    previous = length;
    if (stop.error > 0.0 && next > stop.error && (stop.run_all_iterations || system_.factorIsNear())) {
      const Positions& d = system_.precondition(-point.gradient);
      const double unseen = 1.0 + kErrorPerIteration * system_.lastIterations();
      next = std::min(next, unseen * relativeLength(potential, point, d));
    }
    if (stop.error > 0.0 && next <= stop.error) {
      summary.converged = true;
      if (!stop.run_all_iterations) break;
    }
  }
  return summary;
}

}  // namespace ease
