// Time and error of one implicit step, for every setting of a method: points of a work-precision curve.
//
// Every setting takes the same 16 consecutive steps of a reference trajectory, each from the reference's own
// state, so that errors do not pile up but factors, pairs of L-BFGS and the like live on from step to step as in a run.
// The first step, which analyses and factors, is timed apart (`setup_ms`); each of the others is a repetition.
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
  double from_time = 0.2;  // s: where the steps begin
  int runs = 15;           // steps that are timed
  double slow_s = 0.5;     // s a step: beyond this, the tighter settings of a method are not tried
};

/// Registers a benchmark "step/sheet:S/n:N/k:K/h:H/method:M/KNOB:VALUE" for each setting.  Its counters are those of
/// StepError, iterations and setup_ms; a method that fails is an error of that benchmark.
void registerSteps(const StepCase& step_case, std::span<const Setting> settings);

}  // namespace ease
