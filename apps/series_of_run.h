// Where a run's frames go: the garment, its rest shape and the body, as time series.
#pragma once

#include <filesystem>
#include <optional>

#include "apps/scene.h"
#include "viz/series.h"

namespace ease {

class SeriesOfRun {
 public:
  /// `given`: the meshes before they were renumbered for the run.  Goes on with earlier series up to `keep_until`, s.
  SeriesOfRun(const std::filesystem::path& directory, const SceneInput& given, const InputNumbering& numbering,
              double keep_until = -1.0);

  /// Frames as the run numbers them; they are written as they were before.
  void write(double time_s, const Frame& garment, const Frame& rest);
  void writeBody(double time_s, const Frame& body);
  /// Waits until all are on disk; throws as Series::write().
  void finish();

 private:
  Series garment_, rest_;
  std::optional<Series> body_;
  InputNumbering numbering_;
};

}  // namespace ease
