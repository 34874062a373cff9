// The time series of a run: the garment, its rest shape and the body; of a replay, garment and body.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "adaption/run_watch.h"
#include "apps/scene.h"
#include "viz/series.h"

namespace ease {

class SeriesOfRun {
 public:
  /// Starts the series.  `given`: the meshes as they were before they were renumbered for the run; frames are written
  /// in that numbering.  `first_areas`: areas of the first rest shape's triangles, in the run's numbering, m^2.
  /// `limit`: delta.  Series in the directory are continued: their frames up to `keep_until` (s) stay, later ones are
  /// replaced.
  /// `replay`: which replay it is, empty for the run itself: "before" makes before_garment.pvd and before_body.pvd.
  SeriesOfRun(const std::filesystem::path& directory, const SceneInput& given, const InputNumbering& numbering,
              const std::vector<double>& first_areas, std::optional<double> limit, double keep_until = -1.0,
              const std::string& replay = "");

  void write(const Snapshot& snapshot);
  /// Waits until all frames are on disk; throws like Series::write().
  void finish();

 private:
  Series garment_;
  std::optional<Series> rest_, body_;
  InputNumbering numbering_;
  std::vector<double> first_areas_;
  std::optional<double> limit_;
  std::optional<GarmentAsRead> as_read_;
};

}  // namespace ease
