// Time and error of a whole trajectory.  The error comes from a method's inexact steps and from the length of its
// steps.
//
//   x(t)       positions by the method           x*(t)   2 x_fine(t) - x_coarse(t): Newton's method at h/16 and h/8
//                                                        extrapolated to h = 0 (Richardson; backward Euler has order 1)
//   error         sqrt(sum_t |x - x*|_M^2 / sum_t |x* - x(0)|_M^2), over instants t that all trajectories share
//   method_error  the same formula with x_h instead of x* in the difference; x_h is Newton's method with the same time
//                 step, taken to round-off, so that backward Euler's own error is left out
//   rms_mm        root mean square of x - x* over instants and mass, mm
//
// h is the smallest time step of the curves.
#pragma once

#include <span>

#include "bench/settings.h"
#include "bench/sheets.h"

namespace ease {

struct TrajectoryCase {
  std::string sheet;
  int side = 32;
  double k = 500.0;               // N/m
  std::vector<int> rates;         // time steps per second, ascending; each divides the last
  double duration = 0.25;         // s
  int runs = 15, least_runs = 3;  // largest and smallest number of repetitions
  double enough_s = 0.7;          // s: after this time there are no more than `least_runs` repetitions
  double slow_s = 10.0;           // s per trajectory: if a setting takes longer, tighter ones are skipped
};

/// Registers a benchmark "trajectory/sheet:S/n:N/k:K/h:H/method:M/KNOB:VALUE" for each rate and setting.
void registerTrajectories(const TrajectoryCase& trajectory, std::span<const Setting> settings);

}  // namespace ease
