// From a scene to a run: what the loop in adaption/run.h needs, taken from the scene and the meshes it names.
#pragma once

#include "adaption/run.h"
#include "apps/scene.h"

namespace ease {

/// The run that adapts the garment and writes its frames.
Schedule adaptingSchedule(const Scene& scene);
/// Once through the motion, without adaption and without frames.
Schedule replaySchedule(const Scene& scene);

RunSettings runSettings(const Scene& scene, const Schedule& schedule);

/// `body`: null without one.
RunInput runInput(const Scene& scene, const SceneInput& input, MovingBody* body);

/// Into how many parts the scene's steps are divided.  Throws InputError, naming the scene's file and key, where the
/// body moves too far in a time step.
Substeps substepsOf(const Scene& scene, const SceneInput& input);

/// The scene's body, with interpolation steps divided as substepsOf() says.
MovingBody movingBody(const Scene& scene, const SceneInput& input);

}  // namespace ease
