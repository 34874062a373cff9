#include "apps/series_of_run.h"

#include "apps/frames.h"

namespace ease {

SeriesOfRun::SeriesOfRun(const std::filesystem::path& directory, const SceneInput& given,
                         const InputNumbering& numbering, double keep_until)
    : garment_(directory, "garment", given.garment.triangles, keep_until),
      rest_(directory, "rest", given.garment.triangles, keep_until),
      numbering_(numbering) {
  if (given.body_triangles.rows() > 0) body_.emplace(directory, "body", given.body_triangles, keep_until);
}

void SeriesOfRun::write(double time_s, const Frame& garment, const Frame& rest) {
  garment_.write(time_s, restored(garment, numbering_.garment));
  rest_.write(time_s, restored(rest, numbering_.garment));
}

void SeriesOfRun::writeBody(double time_s, const Frame& body) {
  body_->write(time_s, restored(body, numbering_.body));
}

void SeriesOfRun::finish() {
  garment_.finish();
  rest_.finish();
  if (body_) body_->finish();
}

}  // namespace ease
