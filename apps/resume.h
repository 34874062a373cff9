// Resuming an earlier run from its checkpoint: checks that the scene allows it, and reuses the run's start garment.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "adaption/fit.h"
#include "apps/checkpoint.h"
#include "apps/scene.h"

namespace ease {

constexpr const char* kCheckpoint = "checkpoint.bin";  // file in the directory of a run's results

/// Reads the checkpoint of the earlier run in `directory`.  Throws InputError if there is none.
Checkpoint checkpointIn(const std::filesystem::path& directory);

/// Checks that the scene can be resumed from the checkpoint in `directory`.  Throws InputError naming what differs, if
/// the scene has other time steps or if its motion begins with other poses than the body has already reached.
void checkResumable(const Checkpoint& checkpoint, const std::filesystem::path& directory, const Scene& scene,
                    const SceneInput& input);

/// Gives the garment of `input`, called `name` in messages, the positions with which the earlier run began.  Throws
/// InputError if the triangles differ, and warns if the positions differed.
void takeStartFrom(const StartGarment& earlier, const std::string& name, const Warn& warn, SceneInput& input);

/// Returns fingerprints of the poses that the body has reached after these steps; the last one is that of the pose that
/// the body is moving to.  While the body moves back to an earlier pose, that pose has another fingerprint, because the
/// interpolated shapes between two poses depend on the direction.
std::vector<std::uint64_t> posesMet(const Scene& scene, const SceneInput& input, const StepsDone& done);

/// Returns the fingerprints of all poses of the scene's motion, in its order.
std::vector<std::uint64_t> posesOfWholeMotion(const Scene& scene, const SceneInput& input);

/// Lets the fit go on from the passes of the checkpoint where they are passes of this scene: the same motion and the
/// same paint.  Otherwise they begin anew.  `given`: in the numbering of its files; `input`: in that of the checkpoint;
/// `inputs`: runInputs() of the scene.
void resumeFit(const Checkpoint& checkpoint, const Scene& scene, const SceneInput& given, const SceneInput& input,
               const std::map<std::string, std::string>& inputs, Fit& fit);

/// Fingerprint of the scene's limit and target, cloth, pins and contact, and of their files.  `inputs`: runInputs() of
/// the scene.
std::uint64_t fitSetting(const Scene& scene, const std::map<std::string, std::string>& inputs);

/// Whether a run that goes on keeps the first rest shape that it began with: a fit with other paint begins anew with
/// that.
bool keepsFirstRest(const Checkpoint& checkpoint, const Scene& scene, const SceneInput& input);

/// How a run numbers its garment and body: as the checkpoint that it goes on from, or else along a curve through space.
InputNumbering numberingOf(const SceneInput& input, const std::optional<Checkpoint>& checkpoint);

/// Whether nothing is left to do for the scene after the checkpoint in `directory`, reports included.  A fit that is
/// over is checked again, and goes on where it has to, if anything that it depends on has changed.
bool isAtEnd(const Checkpoint& checkpoint, const std::filesystem::path& directory, const Scene& scene,
             const SceneInput& input);

/// Whether the run in `directory` wrote its report without interruption or failure; `with_replays`: replays included.
bool isFinished(const std::filesystem::path& directory, bool with_replays);

}  // namespace ease
