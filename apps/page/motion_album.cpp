#include "apps/page/motion_album.h"

#include <chrono>
#include <limits>

#include "solver/base/stopwatch.h"
#include "solver/mesh/numbering.h"

namespace ease {

namespace {

ShownMoment shownMoment(const Snapshot& shot, const SceneInput& given, const InputNumbering& numbering,
                        std::optional<double> limit) {
  const double delta = limit.value_or(std::numeric_limits<double>::infinity());
  ShownMoment moment;
  moment.time_s = shot.moment.time_s;
  moment.pose = shot.moment.pose;
  moment.garment = restored(shot.state.positions, numbering.garment.vertices);
  if (shot.body.rows() > 0) moment.body = restored(shot.body, numbering.body.vertices);
  for (const Stretch& s : shot.stretch) {
    moment.sigma_1.push_back(isCrumpled(s, delta) ? std::numeric_limits<float>::quiet_NaN()
                                                  : static_cast<float>(s.sigma_1));
    moment.over.push_back(s.sigma_1 > 1.0 + delta ? 1.0F : 0.0F);
  }
  moment.sigma_1 = restored(moment.sigma_1, numbering.garment.triangles, 1);
  moment.over = restored(moment.over, numbering.garment.triangles, 1);
  if (shot.gap.empty()) return moment;
  if (shot.moment.time_s > 0.0) {
    moment.pressure.assign(shot.pressure.begin(), shot.pressure.end());
    moment.pressure = restored(moment.pressure, numbering.garment.vertices, 1);
  }
  moment.distance.assign(shot.gap.begin(), shot.gap.end());
  moment.distance = restored(moment.distance, numbering.garment.vertices, 1);
  for (size_t v = 0; v < moment.distance.size(); ++v) moment.distance[v] += static_cast<float>(given.offsets[v]);
  return moment;
}

}  // namespace

void fillAlbum(RunWatch& watch, const SceneInput& given, const InputNumbering& numbering, std::optional<double> limit,
               bool poses_only, MotionAlbum& album) {
  using Clock = std::chrono::steady_clock;
  album = {};
  watch.on_measured = [&album, begin = Clock::now()](const MeasuredMoment& moment) {
    album.curve.push_back(moment);
    album.wall_s.push_back(secondsSince(begin));
  };
  watch.on_shown = [&album, &given, &numbering, limit, poses_only](const Snapshot& shot) {
    if (!poses_only || shot.moment.pose >= 0 || shot.moment.last)
      album.moments.push_back(shownMoment(shot, given, numbering, limit));
  };
}

const ShownMoment* momentOfPose(const MotionAlbum& album, int pose) {
  const ShownMoment* found = nullptr;
  for (const ShownMoment& moment : album.moments)
    if (moment.pose == pose) found = &moment;
  return found;
}

}  // namespace ease
