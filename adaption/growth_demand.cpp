#include "adaption/growth_demand.h"

#include <algorithm>

#include "adaption/rest_metric.h"
#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr double kRoundOff = 1e-9;  // of growth that has reached its bound
constexpr int kSmoothingPasses = 1;

}  // namespace

void GrowthDemand::add(const Cloth& cloth, const std::vector<Stretch>& stretch) {
  growth_.resize(stretch.size(), Mat2::Identity());
  fully_grown_.resize(stretch.size(), 0);
  const double act_above = 1.0 + kActAbove * limit_, goal = 1.0 + goal_ * limit_;
  parallelFor(cloth.triangleCount(), 512, [&](int t) {
    const Stretch& s = stretch[t];
    if (s.sigma_1 <= act_above) return;
    const double growth_left = kMaxGrowth / grownAlong(cloth, t, s.direction);
    if (growth_left <= 1.0 + kRoundOff) {
      if (s.sigma_1 > 1.0 + limit_) fully_grown_[t] = 1;
      return;
    }
    const double along = std::min(growth_left, s.sigma_1 / goal), across = std::max(1.0, s.sigma_2 / goal);
    growth_[t] = smallestAboveBoth(growth_[t], growthTensor(along, std::min(along, across), s.direction));
  });
}

bool GrowthDemand::letOut(Cloth& cloth) {
  const bool grows =
      std::any_of(growth_.begin(), growth_.end(), [](const Mat2& growth) { return growth != Mat2::Identity(); });
  if (grows) {
    const std::vector<Mat2> own = growth_;
    smoothGrowth(cloth, kSmoothingPasses, growth_);
    for (size_t t = 0; t < own.size(); ++t) growth_[t] = smallestAboveBoth(growth_[t], own[t]);
    growMetric(growth_, cloth);
  }
  growth_.clear();
  fully_grown_.clear();
  return grows;
}

int GrowthDemand::fullyGrown() const {
  return static_cast<int>(std::count(fully_grown_.begin(), fully_grown_.end(), 1));
}

}  // namespace ease
