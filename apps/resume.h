// Going on from where an earlier run stopped: what there must be, and what must be the same.
#pragma once

#include <filesystem>

#include "apps/checkpoint.h"
#include "apps/scene.h"

namespace ease {

constexpr const char* kCheckpoint = "checkpoint.bin";  // in a run's directory

/// The checkpoint that an earlier run left in `directory`.  Throws InputError where there is none.
Checkpoint checkpointIn(const std::filesystem::path& directory);

/// Throws InputError where the scene is not one that can go on from the checkpoint in `directory`.
void checkGoesOn(const Checkpoint& from, const std::filesystem::path& directory, const Scene& scene,
                 const SceneInput& input);

/// Lets the garment just read, `name`, start as that of the run before.  Throws InputError where its triangles are
/// others; warns where its vertices lie elsewhere.
void startAs(const StartGarment& before, const std::string& name, const Warn& warn, SceneInput& input);

/// Fingerprints of the poses that the body has met when those steps are done, and of the one that it is on its way to,
/// which is another where it runs back than where it runs forth.
std::vector<std::uint64_t> posesMet(const Scene& scene, const SceneInput& input, const StepsDone& done);

/// Whether the run in `directory` ended as it should, with its report, and with replays if they are asked for.
bool isFinished(const std::filesystem::path& directory, bool with_replays);

}  // namespace ease
