#include "adaption/pass_record.h"

#include <algorithm>

namespace ease {

void StretchRecord::add(const StretchStatistics& moment, int pose) {
  ++moments;
  overall.max = std::max(overall.max, moment.max);
  overall.p99 = std::max(overall.p99, moment.p99);
  overall.share_over_limit = std::max(overall.share_over_limit, moment.share_over_limit);
  if (pose < 0) return;
  poses.resize(std::max<size_t>(poses.size(), pose + 1));
  poses[pose] = moment;
}

}  // namespace ease
