// What all moments of a pass ask of the rest shape: for every triangle a growth, as small as is easily found, that
// makes each moment comfortable.
//
//   F = U diag(sigma_i) Vᵀ asks for G = V diag(max(1, sigma_i / (1 + goal limit))) Vᵀ
//                                       where sigma_1 is above a threshold
//
// after Wolff et al. 2022.  Goal and threshold lie below 1 + limit by a margin, so that the limit also holds between
// the measured moments and in a motion that differs a little.  The tensors of the moments are joined one by one, each
// time by the smallest growth that is at least as large as both (smallestAboveBoth()).  The result is at least as large
// as all of them, nearly the smallest such tensor, and depends little on the order of the moments.
#pragma once

#include <vector>

#include "adaption/growth.h"

namespace ease {

/// Strains, as shares of the limit: cloth that is stretched above the first grows until it is stretched to the second.
constexpr double kActAbove = 0.8, kGoal = 0.6;

class GrowthDemand {
 public:
  /// `limit`: largest comfortable strain, delta > 0.  `goal`: strain to which cloth grows, as a share of the limit.
  explicit GrowthDemand(double limit, double goal = kGoal) : limit_(limit), goal_(goal) {}

  /// Adds what a moment asks for.
  void add(const Cloth& cloth, const std::vector<Stretch>& stretch);

  /// Gives the cloth the metric that the moments asked for (rest_metric.h), and forgets the moments.  A triangle grows
  /// as much as it asks for, and at least as much as it and its neighbours ask for on average.  Returns whether any
  /// triangle grew.
  bool letOut(Cloth& cloth);

  /// Number of triangles that were over the limit in a moment although they have grown as far as they may (kMaxGrowth).
  int fullyGrown() const;

 private:
  double limit_, goal_;
  std::vector<Mat2> growth_;
  std::vector<char> fully_grown_;  // 0 or 1
};

}  // namespace ease
