// DIR/checkpoint.bin: everything that is needed to resume a run from one moment of it.
//
// When a run writes a checkpoint, it also discards the state that only makes it faster (factors, L-BFGS pairs, the
// triangle nearest to each sample).  A resumed run, which starts without that state, therefore gives exactly the same
// results, bit for bit, as a run that was never interrupted.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "adaption/fit_state.h"
#include "adaption/run_watch.h"
#include "apps/scene.h"
#include "solver/mesh/numbering.h"

namespace ease {

struct Checkpoint {
  RunState run;
  FitState fit;                   // where the rest shape is fitted in passes; `run` is then at the start of the motion
  std::uint64_t fit_setting = 0;  // fingerprint of the limit, the cloth and contact (resume.h)
  // Fingerprints of the poses that the body has reached, and of the pose that it is moving to (resume.h); after a pass
  // those of the whole motion.
  std::vector<std::uint64_t> poses_met;
  // Timing of the motion; a resumed run must use the same values.
  double time_step_s = 0.0;
  int steps_per_pose = 0;
  int interpolation_steps = 0;  // from one pose to the next; 0: no body
  StartGarment start;
  Numbering numbering;  // the garment's, used in `run`, `first_rest` and `paint`
  RestShape first_rest;
  std::vector<double> paint;  // scale factor of every triangle, already applied to `run.rest`; empty: no paint
};

/// Writes the file under a temporary name and then renames it.  Throws ComputationError naming the file.
void writeCheckpoint(const std::filesystem::path& file, const Checkpoint& checkpoint);

/// Reads a checkpoint.  Throws InputError if the file is missing, damaged or written by another version.
Checkpoint readCheckpoint(const std::filesystem::path& file);

}  // namespace ease
