// The error of one step of a sheet: the distance of a method's result from the step's minimum, which Newton's method
// finds to round-off.
//
//   x        result of the method              x_ref   minimum of the step's potential E
//   x_hat    x_n + h v_n, with pins at their new places: the start of every method
//   |d|_M    sqrt(sum_i m_i |d_i|^2), mass norm
//
//   error        |x - x_ref|_M / the length that [solver] tolerance is relative to (minimiser.h), at x_ref
//   of_start     |x - x_ref|_M / |x_ref - x_hat|_M                  1: no better than no step at all
//   energy_gap   (E(x) - E(x_ref)) / (E(x_hat) - E(x_ref))          may be negative where a step has several minima
#pragma once

#include <vector>

#include "bench/sheets.h"

namespace ease {

struct StepError {
  double error = 0.0, of_start = 0.0, energy_gap = 0.0;
  double largest_mm = 0.0;         // largest distance of a vertex from its reference
  double residual_m_s2 = 0.0;      // largest |dE/dx_i| / m_i
  double sigma_1_max_error = 0.0;  // |difference| of the largest principal stretch, which adaption limits
  double sigma_1_p99_error = 0.0;  // |difference| of the 99th percentile of the principal stretch
};

/// A step of a trajectory and the minimum of its potential.
struct ReferenceStep {
  double time;  // s, at its start
  State start;
  Positions minimum;
};

/// Solves steps by Newton's method down to a residual acceleration (m/s^2); the default reaches round-off.
class ReferenceSolver {
 public:
  explicit ReferenceSolver(const Sheet& sheet, double residual = 1e-9);
  /// Computes the minimum of a step of `h` (s) from its start, and stores it in `step`.
  void findMinimum(double h, ReferenceStep& step);

 private:
  const Sheet& sheet_;
  TimeStep newton_;
};

/// Computes `count` consecutive steps of `h` (s) that begin at about `from_time` (s).  Before that time the sheet is
/// moved by the method `auto` with a tolerance of 1 % per step.
std::vector<ReferenceStep> referenceSteps(const Sheet& sheet, double h, double from_time, int count);

class StepJudge {
 public:
  explicit StepJudge(const Sheet& sheet) : sheet_(sheet), potential_(sheet.cloth) {}
  StepError judge(const ReferenceStep& step, double h, const Positions& x);

 private:
  const Sheet& sheet_;
  IncrementalPotential potential_;
};

/// Returns the mass norm sqrt(sum_i m_i |d_i|^2), m sqrt(kg).
double massNorm(const Cloth& cloth, const Positions& d);

}  // namespace ease
