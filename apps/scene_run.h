// Translation of a scene and its meshes to the settings and inputs of a run (adaption/run.h).
#pragma once

#include "adaption/run.h"
#include "apps/scene.h"

namespace ease {

/// Width beyond the comfort offset where level sets are exact, m.
constexpr double kBeyondComfort = 0.025;

/// Returns the schedule of the run that adapts the garment and writes its frames.
Schedule adaptingSchedule(const Scene& scene);
/// Returns the schedule of a replay: the motion once, without adaption; with frames where replays are written.
Schedule replaySchedule(const Scene& scene);

RunSettings runSettings(const Scene& scene, const Schedule& schedule);

/// Returns the input of a run.  `body` is null for a scene without a body.
RunInput runInput(const Scene& scene, const SceneInput& input, MovingBody* body);

/// Returns the number of substeps into which the scene's steps are divided.  Throws InputError naming the scene's file
/// and key if the body moves too far in one time step.
Substeps substepsOf(const Scene& scene, const SceneInput& input);

/// Makes the scene's moving body, with its interpolation steps divided as substepsOf() says.
MovingBody movingBody(const Scene& scene, const SceneInput& input);

}  // namespace ease
