// Time and error of one implicit step, for every setting of a method: points of a work-precision curve.
//
// Every setting takes the same 16 consecutive steps of a reference trajectory.  Each step starts from the state of the
// reference, so that errors do not accumulate, but factors, L-BFGS pairs and so on are kept from step to step as in a
// run.  The first step, which analyses and factors the system, is timed separately (`setup_ms`); each of the others is
// a repetition.
#pragma once

#include <span>

#include "bench/settings.h"
#include "bench/step_error.h"

namespace ease {

struct StepCase {
  std::string sheet;       // name (sheets.h)
  int side = 32;           // vertices along an edge
  double k = 500.0;        // N/m
  double h = 1.0 / 60.0;   // s
  double from_time = 0.2;  // s: start of the first step
  int runs = 15;           // timed steps
  double slow_s = 0.5;     // s per step: if a setting takes longer, tighter ones are skipped
};

/// Registers a benchmark "step/sheet:S/n:N/k:K/h:H/method:M/KNOB:VALUE" for each setting.  Its counters are the members
/// of StepError, numbers of iterations and setup_ms.  If a method fails, the benchmark has no result.
void registerSteps(const StepCase& step_case, std::span<const Setting> settings);

}  // namespace ease
