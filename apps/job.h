// A complete job: the run that adapts the garment of a scene, the replays that verify the result, and all output files.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>

#include "apps/checkpoint.h"
#include "apps/scene.h"

namespace ease {

/// How a job ended that did not fail: doubtful, where its figures do not mean what they say (doubts.h).
enum class RunEnd { done, doubtful, interrupted };

/// Simulates, adapts and verifies, and writes the results into `directory`, which must exist.  Ends as interrupted if
/// `interrupted` became true before the end, and throws ComputationError if the computation fails; in both cases the
/// files on disk are complete.  `begin`: since when the report counts all time.  `resume_from`: checkpoint at which the
/// run starts.  `append_to_series`: the resumed run writes into the directory of the earlier one and continues its
/// series.
RunEnd runScene(const Scene& scene, const SceneInput& input, const std::filesystem::path& directory,
                const std::atomic<bool>& interrupted, std::chrono::steady_clock::time_point begin,
                const std::optional<Checkpoint>& resume_from = std::nullopt, bool append_to_series = false);

}  // namespace ease
