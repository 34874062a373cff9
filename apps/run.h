// One run of a garment through the body's motion: how one frame is computed, as code.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "apps/checkpoint.h"
#include "apps/report.h"
#include "apps/scene.h"
#include "apps/series_of_run.h"
#include "apps/timeline.h"
#include "collision/moving_body.h"
#include "solver/step/time_step.h"

namespace ease {

struct RunOptions {
  bool adapting = true;                              // the run that adapts and writes; otherwise a replay
  SeriesOfRun* series = nullptr;                     // none: nothing written
  const std::vector<double>* first_areas = nullptr;  // of the first rest shape, m^2
  std::function<void(const Moment&)> on_step;        // after every step
  const std::atomic<bool>* interrupted = nullptr;
  std::function<void(Checkpoint)> keep;  // given now and then, without what the run does not know
  const Checkpoint* from = nullptr;      // go on from there; none: from the start
};

/// The body of a scene, its poses as close as the motion wants them (timeline.h).
MovingBody movingBody(const Scene& scene, const SceneInput& input);

/// Runs the cloth from its start shape through the moments, adapting its rest shape if asked to.  `body` may be null.
/// Fills the record and leaves the last state, also when it throws ComputationError, with the step and time at which it
/// stopped.
void runMotion(const Scene& scene, const SceneInput& input, MovingBody* body, Cloth& cloth, const RunOptions& options,
               State& state, PassRecord& record);

}  // namespace ease
