// All that a run needs to go on from a moment, DIR/checkpoint.bin: state of the cloth, its rest shape, what adaption
// remembers, the clock, and the body's place on its way.
//
// At these moments the run itself forgets what it only remembers to be sooner (factors, pairs of L-BFGS, samples'
// nearest triangles), so that a run that goes on from here does the same to the last bit as one that was never stopped.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "apps/garment_pins.h"
#include "apps/timeline.h"
#include "solver/mesh/numbering.h"
#include "solver/model/rest_shape.h"
#include "solver/step/state.h"

namespace ease {

struct Checkpoint {
  StepsDone done;
  // Fingerprint of every pose that the body has met on its way, and of the one that it is on its way to.
  std::vector<std::uint64_t> poses_met;
  // What steps are counted in; a run that goes on must have the same.
  double time_step_s = 0.0;
  int steps_per_pose = 0;       // time steps per interpolation step
  int interpolation_steps = 0;  // from a pose to the next; 0: no body
  StartGarment start;
  Numbering numbering;  // of the garment, that all below are in
  State state;
  RestShape first_rest, rest;
  std::vector<double> paint;       // of every triangle, as far as `rest` has it; empty: none is painted
  std::vector<Mat2> wanted_edges;  // of the stitcher, m; empty: no adaption so far
  std::vector<PinAnchor> pins;
};

/// Writes the file, temporary name first.  Throws ComputationError naming it.
void writeCheckpoint(const std::filesystem::path& file, const Checkpoint& checkpoint);

/// Throws InputError where there is none, where it is not as it was written, or was written by another version.
Checkpoint readCheckpoint(const std::filesystem::path& file);

}  // namespace ease
