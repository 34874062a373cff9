// The first time steps of a scene's run, with adaption and output, timed in a process of its own, so that its peak
// memory is its own.
#pragma once

#include <string>

#include "adaption/pass_record.h"
#include "apps/scene.h"

namespace ease {

struct JobLimits {
  int steps = 60;         // time steps that are timed, at most
  int least = 3;          // and at least
  double seconds = 15.0;  // after these no further step is begun
};

/// The first step, which analyses and factors, is not among those that are timed.  Seconds are wall time of all of them
/// together.
struct JobTiming {
  int vertices = 0, steps = 0, substeps = 0;
  double setup_s = 0.0;       // reading garment and body
  double first_step_s = 0.0;  // with the first level set
  double run_s = 0.0;         // everything else
  PassTimes times;
  double peak_memory_MB = 0.0;
  double handed_over = 0.0, newton_iterations = 0.0, projective_iterations = 0.0;
  double penetration_mm = 0.0;  // deepest sample
  char failure[256] = "";       // empty, or why the run stopped
};

/// Forks, so that nothing parallel may have run before in this process.
JobTiming timeJob(const Scene& scene, const JobLimits& limits);

/// Makes the scene's garment, in a process of its own as well, and writes it as a mesh.
void writeGarment(const Scene& scene, const std::filesystem::path& file);

/// A folder that is removed in the end.
struct ScratchDirectory {
  std::filesystem::path path;
  ScratchDirectory();
  ~ScratchDirectory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;
};

}  // namespace ease
