// What a run reports: report.json, and a summary on the terminal.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "adaption/stretch_measure.h"
#include "apps/scene.h"
#include "apps/timeline.h"
#include "collision/contacts.h"

namespace ease {

/// Stretch of the cloth through one run of the motion: the worst of all measured moments, and as it was in each pose
/// that was reached.
struct StretchRecord {
  StretchStatistics overall;
  int moments = 0;  // measured
  std::vector<std::optional<StretchStatistics>> poses;
  void measured(const StretchStatistics& moment);
};

/// One run of the motion.
struct PassRecord {
  int steps = 0;
  Division division;  // of those, and of the interpolation steps
  StretchRecord stretch;
  Penetration penetration;
  double wall_s = 0.0;           // the whole pass
  double final_speed_m_s = 0.0;  // largest of a vertex, at the end
  double level_set_s = 0.0, interpolation_s = 0.0, step_s = 0.0, adaption_s = 0.0, output_s = 0.0;
  double level_set_MB = 0.0;
  double contact_stiffness = 0.0;  // N/m^3: the scene's, or more where the body is fast
  long projective_iterations = 0, handed_over = 0, contact_rounds = 0;
  long newton_iterations = 0, cg_iterations = 0, factorisations = 0;
  long halvings = 0, short_of_tolerance = 0, voxels_on_demand = 0, settle_steps = 0, adaptions = 0;
  int fully_grown = 0;  // triangles, at the end
  ContactRescues contact;
};

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
