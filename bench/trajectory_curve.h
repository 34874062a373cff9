// Time and error of a whole trajectory: what a method's error of a step and the length of its steps come to.
//
//   x(t)       where the method is               x*(t)   2 x_fine(t) - x_coarse(t): Newton's method at h/16 and h/8
//                                                        extrapolated to h = 0 (Richardson; backward Euler has order 1)
//   error         sqrt(sum_t |x - x*|_M^2 / sum_t |x* - x(0)|_M^2), over common instants t
//   method_error  the same formula with x_h instead of x* in the difference; x_h is Newton's method with the same time
//                 step, taken to round-off, so that backward Euler's own error is left out
//   rms_mm        x - x*, root mean square over instants and mass, mm
//
// h is the least time step of the curves.
#pragma once

#include <span>

#include "bench/settings.h"
#include "bench/sheets.h"

namespace ease {

struct TrajectoryCase {
  std::string sheet;
  int side = 32;
  double k = 500.0;               // N/m
  std::vector<int> rates;         // time steps per second; each divides the last
  double duration = 0.25;         // s
  int runs = 15, least_runs = 3;  // repetitions: all, or fewer where
  double enough_s = 0.7;          // they have taken so long, s
  double slow_s = 10.0;           // a trajectory: beyond this, the tighter settings of a method are not tried
};

/// Registers a benchmark "trajectory/sheet:S/n:N/k:K/h:H/method:M/KNOB:VALUE" for each rate and setting.
void registerTrajectories(const TrajectoryCase& trajectory, std::span<const Setting> settings);

}  // namespace ease
