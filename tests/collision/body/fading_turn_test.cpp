#include "collision/body/fading_turn.h"

#include <catch2/catch.hpp>

using namespace ease;

TEST_CASE("a fading turn keeps distances from the joint, moves the limb rigidly and leaves the rest") {
  const FadingTurn turn = {{0.1, 0.2, 0.3}, Vec3::UnitX(), {0, 0, 0.9}, 0.3, 2.2, 1.2, 0.05, 0.2};
  const Eigen::Isometry3d whole = wholeTurn(turn);
  const Vec3 on_limb(0.6, 0.21, 0.3), beside(0.12, 0.3, 0.33), behind(-0.3, 0.25, 0.3);
  CHECK(turnWeight(turn, on_limb) == 1.0);
  CHECK((turned(turn, on_limb) - whole * on_limb).norm() < 1e-15);
  CHECK(turnWeight(turn, beside) > 0.05);
  CHECK(turnWeight(turn, beside) < 0.95);
  CHECK((turned(turn, beside) - turn.joint).norm() == Approx((beside - turn.joint).norm()).epsilon(1e-13));
  CHECK(turnWeight(turn, behind) == 0.0);
  CHECK(turned(turn, behind) == behind);
}
