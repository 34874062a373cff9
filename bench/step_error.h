// How far from its minimum a method left a step of a sheet, against Newton's method taken to round-off.
//
//   x        where the method ended            x_ref   the minimum of the step's potential E
//   x_hat    x_n + h v_n, with pins where they go: where every method starts
//   |d|_M    sqrt(sum_i m_i |d_i|^2), norm of the masses
//
//   error        |x - x_ref|_M over the length that [solver] tolerance is relative to (minimiser.h), at x_ref
//   of_start     |x - x_ref|_M / |x_ref - x_hat|_M                  1: no better than no step at all
//   energy_gap   (E(x) - E(x_ref)) / (E(x_hat) - E(x_ref))          may be negative where a step has several minima
#pragma once

#include <vector>

#include "bench/sheets.h"

namespace ease {

struct StepError {
  double error = 0.0, of_start = 0.0, energy_gap = 0.0;
  double largest_mm = 0.0;         // of a vertex
  double residual_m_s2 = 0.0;      // largest |dE/dx_i| / m_i
  double sigma_1_max_error = 0.0;  // |difference| of the largest principal stretch, which adaption looks at
  double sigma_1_p99_error = 0.0;  // and of its 99th percentile
};

/// A step of a trajectory, and its minimum.
struct ReferenceStep {
  double time;  // s, at its start
  State start;
  Positions minimum;
};

/// Newton's method to a residual acceleration (m/s^2): to round-off with the default.
class ReferenceSolver {
 public:
  explicit ReferenceSolver(const Sheet& sheet, double residual = 1e-9);
  /// Fills the minimum of a step of `h` (s) from its start.
  void findMinimum(double h, ReferenceStep& step);

 private:
  const Sheet& sheet_;
  TimeStep newton_;
};

/// Steps of `h` (s), `count` of them one after the other from about `from_time` (s) on.  Until then the sheet moves by
/// `auto`, to 1 % a step.
std::vector<ReferenceStep> referenceSteps(const Sheet& sheet, double h, double from_time, int count);

class StepJudge {
 public:
  explicit StepJudge(const Sheet& sheet) : sheet_(sheet), potential_(sheet.cloth) {}
  StepError judge(const ReferenceStep& step, double h, const Positions& x);

 private:
  const Sheet& sheet_;
  IncrementalPotential potential_;
};

/// sqrt(sum_i m_i |d_i|^2), m sqrt(kg).
double massNorm(const Cloth& cloth, const Positions& d);

}  // namespace ease
