#include "adaption/clip.h"

#include <algorithm>
#include <atomic>

#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr double kMaxGrowthAtATime = 1.02;
constexpr int kSmoothingPasses = 2;

// Hardening: shares of the limit, which rise linearly until the growth given.
constexpr double kActShare = 0.7;             // strain above which cloth grows that has not grown yet
constexpr double kGoalShare = 0.6;            // strain that it grows to
constexpr double kHardening = 0.25;           // added to both shares once cloth has hardened fully
constexpr double kGrowthUntilHardened = 0.7;  // growth above 1 at which that is so

}  // namespace

StretchGoal stretchGoal(double limit, double growth) {
  const double hardened = std::clamp((growth - 1.0) / kGrowthUntilHardened, 0.0, 1.0);
  return {1.0 + (kActShare + kHardening * hardened) * limit, 1.0 + (kGoalShare + kHardening * hardened) * limit};
}

bool StretchClip::clip(const Cloth& cloth, const std::vector<Stretch>& stretch, std::vector<Mat2>& growth) {
  growth.resize(cloth.triangleCount());
  std::atomic<bool> grows = false;
  std::atomic<int> fully_grown = 0;
  parallelFor(cloth.triangleCount(), 512, [&](int t) {
    const Stretch& s = stretch[t];
    const double grown = grownAlong(cloth, t, s.direction);
    const StretchGoal goal = stretchGoal(limit_, grown);
    growth[t].setIdentity();
    if (s.sigma_1 <= goal.act_above) return;
    if (grown >= kMaxGrowth) {
      fully_grown += s.sigma_1 > 1.0 + limit_ ? 1 : 0;
      return;
    }
    grows = true;
    const double g1 = std::clamp(s.sigma_1 / goal.grow_to, 1.0, kMaxGrowthAtATime);
    const double g2 = std::clamp(s.sigma_2 / goal.grow_to, 1.0, kMaxGrowthAtATime);
    growth[t] = growthTensor(g1, g2, s.direction);
  });
  fully_grown_ = fully_grown;
  if (grows) smoothGrowth(cloth, kSmoothingPasses, growth);
  return grows;
}

}  // namespace ease
