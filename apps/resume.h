// Resuming an earlier run from its checkpoint: which scenes may, and what they take over.
#pragma once

#include <filesystem>

#include "apps/checkpoint.h"
#include "apps/scene.h"

namespace ease {

constexpr const char* kCheckpoint = "checkpoint.bin";  // file in the directory of a run's results

/// The checkpoint that an earlier run left in `directory`.  Throws InputError where there is none.
Checkpoint checkpointIn(const std::filesystem::path& directory);

/// Throws InputError, naming what differs, where the scene cannot go on from the checkpoint in `directory`: another
/// clock, or other poses than the body has met.
void checkResumable(const Checkpoint& checkpoint, const std::filesystem::path& directory, const Scene& scene,
                    const SceneInput& input);

/// Gives the garment of `input`, called `name` in messages, the positions that the earlier run began with.  Throws
/// InputError where the triangles differ; warns where the positions did.
void takeStartFrom(const StartGarment& earlier, const std::string& name, const Warn& warn, SceneInput& input);

/// Fingerprints of the poses that the body has met after these steps, the last one being the pose that it is on its way
/// to.  A pose approached on the way back has another fingerprint than on the way forth, since the shapes between two
/// poses differ by direction.
std::vector<std::uint64_t> posesMet(const Scene& scene, const SceneInput& input, const StepsDone& done);

/// Whether the run in `directory` wrote its report without interruption or failure; `with_replays`: replays included.
bool isFinished(const std::filesystem::path& directory, bool with_replays);

}  // namespace ease
