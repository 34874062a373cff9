#include "adaption/clip.h"

#include <algorithm>

#include "solver/linear/parallel.h"

namespace ease {

ClipOptions clipOptions(double limit) {
  return {0.95 * limit, 0.8 * limit, 2};
}

bool clipStretch(const Cloth& cloth, const std::vector<Stretch>& stretch, const ClipOptions& options,
                 std::vector<Mat2>& growth) {
  const int m = cloth.triangleCount();
  const bool any = std::any_of(stretch.begin(), stretch.end(),
                               [&](const Stretch& s) { return s.sigma_1 > 1.0 + options.act_above; });
  growth.assign(m, Mat2::Identity());
  if (!any) return false;
  parallelFor(m, 512, [&](int t) {
    const Stretch& s = stretch[t];
    if (s.sigma_1 <= 1.0 + options.act_above) return;
    const double g1 = std::max(1.0, s.sigma_1 / (1.0 + options.grow_to));
    const double g2 = std::max(1.0, s.sigma_2 / (1.0 + options.grow_to));
    growth[t] = g2 * Mat2::Identity() + (g1 - g2) * s.direction * s.direction.transpose();
  });

  std::vector<Mat2> smoothed(m);
  for (int pass = 0; pass < options.smoothing; ++pass) {
    parallelFor(m, 512, [&](int t) {
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
  return true;
}

}  // namespace ease
