#include "apps/series_of_run.h"

#include "apps/frames.h"

namespace ease {

SeriesOfRun::SeriesOfRun(const std::filesystem::path& directory, const Triangles& garment_triangles,
                         const Numbering& numbering, const Triangles& body_triangles, double keep_until)
    : garment_(directory, "garment", garment_triangles, keep_until),
      rest_(directory, "rest", garment_triangles, keep_until),
      numbering_(numbering) {
  if (body_triangles.rows() > 0) body_.emplace(directory, "body", body_triangles, keep_until);
}

void SeriesOfRun::write(double time_s, const Frame& garment, const Frame& rest) {
  garment_.write(time_s, restored(garment, numbering_));
  rest_.write(time_s, restored(rest, numbering_));
}

void SeriesOfRun::writeBody(double time_s, Frame body) {
  body_->write(time_s, std::move(body));
}

void SeriesOfRun::finish() {
  garment_.finish();
  rest_.finish();
  if (body_) body_->finish();
}

}  // namespace ease
