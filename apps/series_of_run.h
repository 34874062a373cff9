// Where a run's frames go: the garment, its rest shape and the body, as time series.
#pragma once

#include <filesystem>
#include <optional>

#include "solver/mesh/numbering.h"
#include "viz/series.h"

namespace ease {

class SeriesOfRun {
 public:
  /// `garment_triangles`: as they were before the garment was renumbered for the run.  `body_triangles` may be empty:
  /// no body.  Goes on with earlier series up to `keep_until`, s.
  SeriesOfRun(const std::filesystem::path& directory, const Triangles& garment_triangles, const Numbering& numbering,
              const Triangles& body_triangles, double keep_until = -1.0);

  /// Frames of the garment and its rest shape as the run numbers them; they are written as they were before.
  void write(double time_s, const Frame& garment, const Frame& rest);
  void writeBody(double time_s, Frame body);
  /// Waits until all are on disk; throws as Series::write().
  void finish();

 private:
  Series garment_, rest_;
  std::optional<Series> body_;
  Numbering numbering_;
};

}  // namespace ease
