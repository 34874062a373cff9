// What a run reports: report.json, and a summary on the terminal.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "adaption/pass_record.h"
#include "apps/scene.h"

namespace ease {

struct Report {
  int vertices = 0, triangles = 0;
  double time_step_s = 0.0;
  double limit = 0.0;  // 0: no adaption
  std::vector<std::string> pose_names;
  std::optional<int> resumed_from_step;  // of a run that goes on; all it counts, it counts from there
  PassRecord run;
  bool verified = false;
  PassRecord before, after;  // replays on the first and on the adapted rest shape
  int folded_edges = 0;      // of the rest shape (stitch.h)
  double growth_max = 1.0, growth_p99 = 1.0, growth_area_ratio = 1.0;
  double setup_s = 0.0, total_s = 0.0;
  bool interrupted = false;
  std::string failure;  // empty, or where and why the computation stopped
  std::vector<std::string> warnings;
};

/// Writes report.json into the directory, temporary name first.  Throws ComputationError naming the file.
void writeReport(const Report& report, const Scene& scene, const std::filesystem::path& directory);

/// One line each for the garment that goes deep into the body, in the run or in the adapted garment's replay.
std::vector<std::string> depthWarnings(const Report& report);

/// A few lines for people.
std::string summaryText(const Report& report);

}  // namespace ease
