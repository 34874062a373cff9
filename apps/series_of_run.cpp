#include "apps/series_of_run.h"

#include "apps/frames.h"

namespace ease {

SeriesOfRun::SeriesOfRun(const std::filesystem::path& directory, const SceneInput& given,
                         const InputNumbering& numbering, const std::vector<double>& first_areas,
                         std::optional<double> limit, double keep_until, const std::string& replay)
    : garment_(directory, replay.empty() ? "garment" : replay + "_garment", trianglesAsRead(given), keep_until),
      numbering_(numbering),
      first_areas_(first_areas),
      limit_(limit),
      as_read_(given.as_read) {
  if (replay.empty()) rest_.emplace(directory, "rest", trianglesAsRead(given), keep_until);
  if (given.body_triangles.rows() > 0)
    body_.emplace(directory, replay.empty() ? "body" : replay + "_body", given.body_triangles, keep_until);
}

void SeriesOfRun::write(const Snapshot& snapshot) {
  const double time_s = snapshot.moment.time_s;
  const GarmentFields fields{snapshot.stretch, first_areas_, snapshot.gap, snapshot.pressure, snapshot.pinned, limit_};
  const Frame garment = garmentFrame(snapshot.cloth, snapshot.state, fields);
  if (body_) body_->write(time_s, restored(Frame{snapshot.body, {}, {}}, numbering_.body));
  garment_.write(time_s, asRead(restored(garment, numbering_.garment), as_read_));
  if (rest_)
    rest_->write(time_s, asRead(restored(restFrame(snapshot.cloth, first_areas_), numbering_.garment), as_read_));
}

void SeriesOfRun::finish() {
  garment_.finish();
  if (rest_) rest_->finish();
  if (body_) body_->finish();
}

}  // namespace ease
