// DIR/checkpoint.bin: all that a run needs to go on from a moment.
//
// At these moments the run forgets what it remembers only to be faster (factors, L-BFGS pairs, the triangles nearest to
// samples), so that a run that goes on from here does the same to the last bit as one that was never stopped.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "adaption/run.h"
#include "apps/scene.h"
#include "solver/mesh/numbering.h"

namespace ease {

struct Checkpoint {
  RunState run;
  // Fingerprints of the poses that the body has met, and of the one that it is on its way to (resume.h).
  std::vector<std::uint64_t> poses_met;
  // The clock; a run that goes on must have the same.
  double time_step_s = 0.0;
  int steps_per_pose = 0;
  int interpolation_steps = 0;  // from a pose to the next; 0: no body
  StartGarment start;
  Numbering numbering;  // of the garment; `run`, `first_rest` and `paint` are numbered like this
  RestShape first_rest;
  std::vector<double> paint;  // scale factor of every triangle that `run.rest` has already; empty: none is painted
};

/// Writes the file, temporary name first.  Throws ComputationError naming it.
void writeCheckpoint(const std::filesystem::path& file, const Checkpoint& checkpoint);

/// Throws InputError where there is none, where it is not as it was written, or was written by another version.
Checkpoint readCheckpoint(const std::filesystem::path& file);

}  // namespace ease
