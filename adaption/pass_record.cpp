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

}  // namespace ease
