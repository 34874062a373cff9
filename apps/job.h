// A scene from start to end: the run that adapts, the replays that verify it, and all that is written.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>

#include "apps/checkpoint.h"
#include "apps/scene.h"

namespace ease {

/// Simulates, adapts, verifies and writes into `directory`, which exists.  Returns false if `interrupted` became true
/// before the end; what is on disk then is whole, as it is where this throws ComputationError.  `resume_from`: the run
/// goes on from there.  `append_to_series`: it goes on in the same directory, whose series it continues.
bool runScene(const Scene& scene, const SceneInput& input, const std::filesystem::path& directory,
              const std::atomic<bool>& interrupted, const std::optional<Checkpoint>& resume_from = std::nullopt,
              bool append_to_series = false);

}  // namespace ease
