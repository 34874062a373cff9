#include "adaption/growth.h"

#include <algorithm>
#include <cmath>

#include "solver/base/parallel.h"

namespace ease {

namespace {

/// Square root of a symmetric positive definite 2x2 matrix: (M + d I) / sqrt(tr M + 2 d), d = sqrt(det M).
Mat2 squareRoot(const Mat2& M) {
  const double d = std::sqrt(M.determinant());
  return (M + d * Mat2::Identity()) / std::sqrt(M.trace() + 2.0 * d);
}

}  // namespace

Mat2 growthTensor(double along, double across, const Eigen::Vector2d& direction) {
  return across * Mat2::Identity() + (along - across) * direction * direction.transpose();
}

Mat2 smallestAboveBoth(const Mat2& a, const Mat2& b) {
  if (b == Mat2::Identity()) return a;
  if (a == Mat2::Identity()) return b;
  const Mat2 relative = b * a.inverse();
  const Stretch s = principalStretch(relative.transpose() * relative);
  if (s.sigma_1 <= 1.0) return a;
  const Mat2 enlarged = growthTensor(s.sigma_1, std::max(1.0, s.sigma_2), s.direction) * a;
  return squareRoot(enlarged.transpose() * enlarged);
}

double grownAlong(const Cloth& cloth, int t, const Eigen::Vector2d& direction) {
  const Mat2 to_first = cloth.first().edges[t] * cloth.restInverse()[t];
  return 1.0 / (to_first * direction).norm();
}

void smoothGrowth(const Cloth& cloth, int passes, std::vector<Mat2>& growth) {
  std::vector<Mat2> smoothed(growth.size());
  for (int pass = 0; pass < passes; ++pass) {
    parallelFor(cloth.triangleCount(), 512, [&](int t) {
      Mat2 sum = growth[t];
      int count = 1;
      for (int corner = 0; corner < 3; ++corner) {
        const Edge& edge = cloth.topology().edges[cloth.topology().triangle_edges(t, corner)];
        const int other = edge.triangleAcross(t);
        if (other < 0) continue;
        sum += growth[other];
        ++count;
      }
      smoothed[t] = sum / count;
    });
    growth.swap(smoothed);
  }
}

}  // namespace ease
