#include "adaption/stretch_measure.h"

#include <algorithm>
#include <cmath>

#include "solver/base/parallel.h"
#include "solver/base/percentile.h"

namespace ease {

Stretch principalStretch(const Mat2& metric) {
  const double mean = 0.5 * (metric(0, 0) + metric(1, 1));
  const double difference = 0.5 * (metric(0, 0) - metric(1, 1));
  const double radius = std::hypot(difference, metric(0, 1));
  Stretch s;
  s.sigma_1 = std::sqrt(std::max(0.0, mean + radius));
  s.sigma_2 = std::sqrt(std::max(0.0, mean - radius));
  s.warp = std::sqrt(metric(0, 0));
  s.weft = std::sqrt(metric(1, 1));
  const double angle = 0.5 * std::atan2(metric(0, 1), difference);
  s.direction = {std::cos(angle), std::sin(angle)};
  return s;
}

void measureStretch(const Cloth& cloth, const Positions& x, std::vector<Stretch>& stretch) {
  stretch.resize(cloth.triangleCount());
  parallelFor(cloth.triangleCount(), 512, [&](int t) {
    const Mat32 F = cloth.deformation(x, t);
    stretch[t] = principalStretch(F.transpose() * F);
  });
}

StretchStatistics stretchStatistics(std::vector<double> values, double limit) {
  if (values.empty()) return {};
  StretchStatistics s;
  s.share_over_limit =
      static_cast<double>(std::count_if(values.begin(), values.end(), [&](double v) { return v > 1.0 + limit; })) /
      static_cast<double>(values.size());
  s.p99 = percentile(values, 0.99);
  s.max = *std::max_element(values.begin(), values.end());
  return s;
}

bool isCrumpled(const Stretch& stretch, double limit) {
  return stretch.sigma_1 > 1.0 + limit && stretch.sigma_2 < 1.0 &&
         std::max(stretch.warp, stretch.weft) <= 1.0 + 0.5 * limit;
}

StretchStatistics momentStatistics(const std::vector<Stretch>& stretch, double limit) {
  StretchStatistics s = stretchStatistics(firstStretches(stretch), limit);
  const auto crumpled =
      std::count_if(stretch.begin(), stretch.end(), [&](const Stretch& one) { return isCrumpled(one, limit); });
  s.taut_share_over_limit = s.share_over_limit;
  if (!stretch.empty()) s.taut_share_over_limit -= static_cast<double>(crumpled) / static_cast<double>(stretch.size());
  return s;
}

std::vector<double> firstStretches(const std::vector<Stretch>& stretch) {
  std::vector<double> values(stretch.size());
  std::transform(stretch.begin(), stretch.end(), values.begin(), [](const Stretch& s) { return s.sigma_1; });
  return values;
}

}  // namespace ease
