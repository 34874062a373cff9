// Times the first time steps of a scene's run, with adaption and output.  The run has a process of its own, so that its
// peak memory can be measured.
#pragma once

#include <string>

#include "adaption/pass_record.h"
#include "apps/scene.h"

namespace ease {

struct JobLimits {
  int steps = 60;         // largest number of timed steps
  int least = 3;          // smallest number of timed steps
  double seconds = 15.0;  // s: after this time no further step is begun
};

/// Times of a job: wall time of all timed steps together.  The first step, which analyses and factors the system, is
/// not one of them.
struct JobTiming {
  int vertices = 0, steps = 0, substeps = 0;
  double setup_s = 0.0;       // reading garment and body
  double first_step_s = 0.0;  // first step, including the first level set
  double run_s = 0.0;         // all timed steps
  PassTimes times;
  double peak_memory_MB = 0.0;
  double handed_over = 0.0, newton_iterations = 0.0, projective_iterations = 0.0;
  double penetration_mm = 0.0;  // depth of the deepest point in the body
  char failure[256] = "";       // reason why the run stopped, or empty
};

/// Runs and times a job in a child process.  It calls fork(), so this process must not have started any threads before.
JobTiming timeJob(const Scene& scene, const JobLimits& limits);

/// Makes the scene's garment and writes it as a mesh, also in a child process.
void writeGarment(const Scene& scene, const std::filesystem::path& file);

/// A temporary folder, which the destructor removes.
struct ScratchDirectory {
  std::filesystem::path path;
  ScratchDirectory();
  ~ScratchDirectory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;
};

}  // namespace ease
