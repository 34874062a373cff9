#include "adaption/pass_record.h"

#include <algorithm>

namespace ease {

void StretchRecord::add(const StretchStatistics& moment, int pose) {
  ++moments;
  overall.max = std::max(overall.max, moment.max);
  overall.p99 = std::max(overall.p99, moment.p99);
  overall.share_over_limit = std::max(overall.share_over_limit, moment.share_over_limit);
  overall.taut_share_over_limit = std::max(overall.taut_share_over_limit, moment.taut_share_over_limit);
  if (pose < 0) return;
  poses.resize(std::max<size_t>(poses.size(), pose + 1));
  poses[pose] = moment;
}

PassTimes& PassTimes::operator+=(const PassTimes& other) {
  total += other.total;
  step += other.step;
  interpolation += other.interpolation;
  level_set += other.level_set;
  adaption += other.adaption;
  output += other.output;
  return *this;
}

PassRecord& PassRecord::operator+=(const PassRecord& later) {
  steps += later.steps;
  settle_steps += later.settle_steps;
  adaptions += later.adaptions;
  fully_grown = later.fully_grown;
  substeps = later.substeps;
  const int moments = stretch.moments + later.stretch.moments;
  stretch.add(later.stretch.overall, -1);
  stretch.moments = moments;
  stretch.poses = later.stretch.poses;
  penetration.vertices = std::max(penetration.vertices, later.penetration.vertices);
  penetration.edge_midpoints = std::max(penetration.edge_midpoints, later.penetration.edge_midpoints);
  penetration.centroids = std::max(penetration.centroids, later.penetration.centroids);
  penetration.triangles = std::max(penetration.triangles, later.penetration.triangles);
  final_speed_m_s = later.final_speed_m_s;
  if (later.fastest.speed_m_s > fastest.speed_m_s) fastest = later.fastest;
  on_body = later.on_body;
  contact_stiffness = later.contact_stiffness;
  solver += later.solver;
  contact.held += later.contact.held;
  contact.limited += later.contact.limited;
  voxels_on_demand += later.voxels_on_demand;
  level_set_MB = std::max(level_set_MB, later.level_set_MB);
  times += later.times;
  return *this;
}

}  // namespace ease
