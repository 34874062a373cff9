#include "collision/body/gradient_interpolation.h"

#include <catch2/catch.hpp>

#include "tests/collision/body/posed_limbs.h"

using namespace ease;

TEST_CASE("in the gradient domain a part of a rigid turn, and of a stretch, is that part of it") {
  const TriangleMesh from = makeLimb(0.4);
  const Vec3 axis = Vec3(1.0, 1.0, 0.0).normalized();
  const double angle = GENERATE(0.0, 0.5, 3.1), scale = GENERATE(1.0, 1.4);
  const Positions to = scale * from.positions * Eigen::AngleAxisd(angle, axis).toRotationMatrix().transpose();
  GradientInterpolation interpolation(from.triangles, from.positions, to);
  CHECK(interpolation.largestTurn() == Approx(angle).margin(1e-7));
  Positions x;
  for (const double s : {0.1, 0.5, 0.9}) {
    interpolation.at(s, x);
    const Mat3 part = Eigen::AngleAxisd(s * angle, axis).toRotationMatrix();
    Positions expected = (1.0 - s + s * scale) * from.positions * part.transpose();
    expected.rowwise() += (x.row(0) - expected.row(0));
    CHECK(largestMove(x, expected) < 1e-10);
  }
}

TEST_CASE("turns beyond half a turn are unwound from neighbour to neighbour") {
  const TriangleMesh straight = makeLimb(0.0);
  for (const double angle : {2.0, 3.5, 5.0}) {
    const GradientInterpolation bent(straight.triangles, straight.positions, makeLimb(angle).positions);
    CHECK(bent.largestTurn() > 0.99 * angle);
    CHECK(bent.largestTurn() < angle + 0.8);  // triangles at the bend shear, which turns some of them further
  }
}

TEST_CASE("a limb turns without a jump and keeps its lengths, also by more than half a turn") {
  for (const double angle : {1.5, 3.0, 3.5}) {
    const TriangleMesh from = makeLimb(0.0), to = makeLimb(angle);
    GradientInterpolation interpolation(from.triangles, from.positions, to.positions);
    Positions x, before;
    interpolation.at(0.0, before);
    const auto edgeLength = [&](const Positions& at) {
      return (at.row(from.triangles(40, 0)) - at.row(from.triangles(40, 1))).norm();
    };
    for (int k = 1; k <= 50; ++k) {
      interpolation.at(k / 50.0, x);
      CHECK(largestMove(x, before) < 0.52 * angle / 50.0 * 1.5);  // no jump: about the arm's length times the turn
      CHECK(edgeLength(x) == Approx(edgeLength(from.positions)).epsilon(0.15));
      before = x;
    }
  }
}

TEST_CASE("an ordering found before serves as well") {
  const TriangleMesh a = makeLimb(0.0), b = makeLimb(1.0);
  GradientInterpolation first(a.triangles, a.positions, b.positions);
  GradientInterpolation second(a.triangles, a.positions, b.positions,
                               systemOrdering(static_cast<int>(a.positions.rows()), a.triangles));
  Positions x, y;
  first.at(0.3, x);
  second.at(0.3, y);
  CHECK(x != a.positions);
  CHECK(largestMove(x, y) < 1e-9);
}
