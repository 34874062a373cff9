#include "adaption/clip.h"

#include <algorithm>
#include <atomic>

#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr double kGrowthAtATime = 1.02;
constexpr int kSmoothing = 2;  // passes over neighbours

void smooth(const Cloth& cloth, std::vector<Mat2>& growth) {
  std::vector<Mat2> smoothed(growth.size());
  for (int pass = 0; pass < kSmoothing; ++pass) {
    parallelFor(cloth.triangleCount(), 512, [&](int t) {
      Mat2 sum = growth[t];
      int count = 1;
      for (int corner = 0; corner < 3; ++corner) {
        const Edge& edge = cloth.topology().edges[cloth.topology().triangle_edges(t, corner)];
        const int other = edge.triangle[0] == t ? edge.triangle[1] : edge.triangle[0];
        if (other < 0) continue;
        sum += growth[other];
        ++count;
      }
      smoothed[t] = sum / count;
    });
    growth.swap(smoothed);
  }
}

}  // namespace

StretchGoal stretchGoal(double limit, double growth) {
  const double hardened = std::clamp((growth - 1.0) / 0.7, 0.0, 1.0);
  return {1.0 + (0.7 + 0.25 * hardened) * limit, 1.0 + (0.6 + 0.25 * hardened) * limit};
}

StretchClip::StretchClip(const Cloth& cloth, double limit) : first_edges_(cloth.restEdges()), limit_(limit) {}

bool StretchClip::clip(const Cloth& cloth, const std::vector<Stretch>& stretch, std::vector<Mat2>& growth) {
  growth.resize(cloth.triangleCount());
  std::atomic<bool> any = false;
  std::atomic<int> fully_grown = 0;
  parallelFor(cloth.triangleCount(), 512, [&](int t) {
    const Stretch& s = stretch[t];
    const Mat2 to_first = first_edges_[t] * cloth.restInverse()[t];
    const double grown = 1.0 / (to_first * s.direction).norm();
    const StretchGoal goal = stretchGoal(limit_, grown);
    growth[t].setIdentity();
    if (s.sigma_1 <= goal.act_above) return;
    if (grown >= kMostGrowth) {
      fully_grown += s.sigma_1 > 1.0 + limit_ ? 1 : 0;
      return;
    }
    any = true;
    const double g1 = std::clamp(s.sigma_1 / goal.grow_to, 1.0, kGrowthAtATime);
    const double g2 = std::clamp(s.sigma_2 / goal.grow_to, 1.0, kGrowthAtATime);
    growth[t] = g2 * Mat2::Identity() + (g1 - g2) * s.direction * s.direction.transpose();
  });
  fully_grown_ = fully_grown;
  if (any) smooth(cloth, growth);
  return any;
}

}  // namespace ease
