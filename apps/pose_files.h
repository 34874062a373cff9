// Reads the files of the body's poses and makes one closed body of them: cut, welded and closed the same way in every
// pose, in metres, y up, each pose standing where the one before it stands.
#pragma once

#include "apps/scene.h"

namespace ease {

/// Reads the poses of `scene.body` into `input`. `garment`: its vertices on the first pose, m, so that holes of the
/// body near them are refused; null: not known yet. Throws InputError naming the file.
void readFilePoses(const Scene& scene, const Positions* garment, const Warn& warn, const Pause& pause,
                   SceneInput& input);

/// Warns where the body moves faster than people do, or where a limb turns so far from a pose to the next that it may
/// take the shorter way through the body.  `input.way` must have been computed.
void checkMotion(const Scene& scene, const SceneInput& input, const Warn& warn);

}  // namespace ease
