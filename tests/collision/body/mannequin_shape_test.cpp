#include "collision/body/mannequin_shape.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "collision/body/mannequin.h"

using namespace ease;

TEST_CASE("the vertices of the T-pose lie on the implicit surface") {
  const Positions x = mannequin("t").positions;
  double furthest = 0.0;
  for (int v = 0; v < x.rows(); ++v) furthest = std::max(furthest, std::abs(mannequinDistance(x.row(v)).value));
  CHECK(furthest < 1e-5);
}

TEST_CASE("the gradient of the mannequin's distance agrees with finite differences at its surface") {
  const Positions positions = mannequin("t").positions;
  constexpr double kStep = 1e-6;
  double worst = 0.0;
  for (int v = 0; v < positions.rows(); v += 97) {
    const Vec3 x = positions.row(v);
    const Vec3 gradient = mannequinDistance(x).gradient;
    CHECK(gradient.norm() > 0.5);
    for (int k = 0; k < 3; ++k) {
      const Vec3 step = kStep * Vec3::Unit(k);
      const double slope = (mannequinDistance(x + step).value - mannequinDistance(x - step).value) / (2.0 * kStep);
      worst = std::max(worst, std::abs(slope - gradient[k]));
    }
  }
  CHECK(worst < 0.05);  // the gradient leaves out how a flattened limb's slope varies, where it is blended
}
