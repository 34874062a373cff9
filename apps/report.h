// The report of a run: report.json, and a summary on the terminal.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "adaption/fit_state.h"
#include "apps/rest_shape_files.h"
#include "apps/scene.h"

namespace ease {

class Fit;

struct Report {
  int vertices = 0, triangles = 0;
  double time_step_s = 0.0;
  double limit = 0.0;  // delta: principal stretch at most 1 + delta; 0: no adaption
  std::vector<std::string> pose_names;
  std::map<std::string, std::string> inputs;  // hashes (run_inputs.h)
  std::optional<int> resumed_from_step;       // time step at which a resumed run began; its counts start there
  PassRecord run;                             // sum over all passes, where the rest shape is fitted in passes
  bool verified = false;
  PassRecord before, after;  // replays with the first and with the adapted rest shape
  FitState fit;              // its passes; none where the rest shape is not fitted in passes
  FitResult fit_result;
  std::optional<double> time_to_fit_s;  // from the start of the command to the verified rest shape
  int folded_edges = 0;                 // in the adapted rest shape (stitch.h)
  RestGrowth growth;
  double setup_s = 0.0;
  double total_s = 0.0;  // from the start of the command until the report is written
  bool interrupted = false;
  std::string failure;  // where and why the computation failed; empty if it did not
  std::vector<std::string> warnings;
  std::vector<std::string> doubts;  // why the figures cannot be trusted (doubts.h)
};

/// Rate, 1/s; 0 where no time passed.
inline double perSecond(int count, double seconds) {
  return seconds > 0.0 ? count / seconds : 0.0;
}

/// Fills in what is known before the run: sizes, limit, names of the poses and warnings about the input.
void describe(const Scene& scene, const SceneInput& input, const Cloth& cloth, Report& report);

/// Records the passes of a fit, and, if it has ended, the replays before and after.  `wall_s`: since the start, s.
void recordFit(const Fit& fit, double wall_s, Report& report);

/// Writes report.json into the directory under a temporary name and then renames it.  Throws ComputationError naming
/// the file.
void writeReport(const Report& report, const Scene& scene, const std::filesystem::path& directory);

/// Returns warnings, one line each, if the garment penetrated deep into the body during the run or during the replay of
/// the adapted garment, or if triangles that have grown as far as they may are over the limit.
std::vector<std::string> runWarnings(const Report& report);

/// Returns the summary of a few lines that the program prints at the end.
std::string summaryText(const Report& report);

}  // namespace ease
