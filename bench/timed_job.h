// The first time steps of a scene's run, with adaption and output, timed in a process of its own, so that its peak
// memory is its own.
#pragma once

#include <string>

#include "apps/scene.h"

namespace ease {

struct JobLimits {
  int steps = 48;         // time steps at most
  double seconds = 30.0;  // then no further step is begun
};

/// Seconds are wall time of all steps together.
struct JobTiming {
  int vertices = 0, steps = 0, substeps = 0;
  double setup_s = 0.0;  // reading or making the garment, the body, analysing
  double run_s = 0.0;    // everything else
  double step_s = 0.0, level_set_s = 0.0, interpolation_s = 0.0, adaption_s = 0.0, output_s = 0.0;
  double peak_memory_MB = 0.0;
  long voxels_on_demand = 0, handed_over = 0, newton_iterations = 0, projective_iterations = 0;
  double penetration_mm = 0.0;  // deepest sample
  char failure[256] = "";       // empty, or why the run stopped
};

/// Forks, so that nothing parallel may have run before in this process.
JobTiming timeJob(const Scene& scene, const JobLimits& limits);

}  // namespace ease
