// A scene from start to end: the run that adapts, the replays that verify it, and all that is written.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>

#include "apps/checkpoint.h"
#include "apps/scene.h"

namespace ease {

/// Simulates, adapts, verifies and writes into `directory`, which exists.  Returns false if `interrupted` became true
/// on the way; what is on disk then is whole.  Throws ComputationError, likewise.  `from`: goes on from there; `here`:
/// with the series that are in the directory.
bool runScene(const Scene& scene, const SceneInput& input, const std::filesystem::path& directory,
              const std::atomic<bool>& interrupted, const std::optional<Checkpoint>& from = std::nullopt,
              bool here = false);

}  // namespace ease
