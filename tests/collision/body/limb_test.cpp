#include "collision/body/limb.h"

#include <catch2/catch.hpp>
#include <functional>

#include "tests/differences.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

const Vec3 kA(0.0, 0.0, 0.0), kB(0.3, 0.0, 0.0);

/// Largest difference between a gradient and central differences of the value, at random points around the limb.
double gradientError(const std::function<Distance(const Vec3&)>& field) {
  const Positions points = randomPositions(50, 3);
  double worst = 0.0;
  for (int i = 0; i < points.rows(); ++i) {
    const Vec3 x = 0.3 * points.row(i).transpose() + Vec3(0.15, 0.0, 0.0);
    Vec3 slope;
    for (int axis = 0; axis < 3; ++axis)
      slope[axis] = difference([&](double s) { return field(x + s * Vec3::Unit(axis)).value; }, 1e-6);
    worst = std::max(worst, (slope - field(x).gradient).norm());
  }
  return worst;
}

}  // namespace

TEST_CASE("the distance to a round limb is that to a capsule, a cone and its end spheres") {
  const Limb capsule = taperedLimb(kA, kB, 0.05, 0.05);
  CHECK(limbDistance(capsule, {0.1, 0.2, 0.0}).value == Approx(0.15));
  CHECK(limbDistance(capsule, {-0.1, 0.0, 0.0}).value == Approx(0.05));
  CHECK(limbDistance(capsule, {0.1, 0.0, 0.0}).value == Approx(-0.05));
  const Limb cone = taperedLimb(kA, kB, 0.08, 0.05);
  const double sine = 0.1, cosine = std::sqrt(1.0 - sine * sine);  // (r_a - r_b) / |b - a|
  const Vec3 on_side = kA + 0.08 * Vec3(sine, cosine, 0.0) + 0.1 * Vec3(cosine, -sine, 0.0);
  CHECK(limbDistance(cone, on_side).value == Approx(0.0).margin(1e-12));
  CHECK(limbDistance(cone, on_side + 0.03 * Vec3(sine, cosine, 0.0)).value == Approx(0.03));
  CHECK(limbDistance(cone, {0.4, 0.0, 0.0}).value == Approx(0.05));
}

TEST_CASE("gradients of limbs and of their unions are those of the values") {
  const Limb round = taperedLimb(kA, kB, 0.08, 0.05);
  const Limb across = taperedLimb({0.15, -0.2, 0.0}, {0.15, 0.2, 0.0}, 0.06, 0.04);
  CHECK(gradientError([&](const Vec3& x) { return limbDistance(round, x); }) < 1e-6);
  CHECK(gradientError(
            [&](const Vec3& x) { return smoothUnion(limbDistance(round, x), limbDistance(across, x), 0.1); }) < 1e-6);
  CHECK(gradientError([&](const Vec3& x) {
          return smoothIntersection(limbDistance(round, x), limbDistance(across, x), 0.1);
        }) < 1e-6);
}

TEST_CASE("a flat limb is as thick as its ratio says") {
  const Limb flat = taperedLimb(kA, kB, 0.08, 0.08, Vec3::UnitZ(), 0.5);
  CHECK(limbDistance(flat, {0.15, 0.08, 0.0}).value == Approx(0.0).margin(1e-12));
  CHECK(limbDistance(flat, {0.15, 0.0, 0.04}).value == Approx(0.0).margin(1e-12));
  CHECK(limbDistance(flat, {0.15, 0.0, 0.041}).value == Approx(0.001).epsilon(0.01));
}

TEST_CASE("a smooth union is the sharp one outside of the blend, and a sixth of it less where both are equal") {
  const Distance one{0.02, Vec3::UnitX()}, other{0.05, Vec3::UnitY()};
  CHECK(smoothUnion(one, other, 0.03).value == Approx(0.02));
  CHECK(smoothUnion(one, other, 0.0).value == 0.02);
  CHECK(smoothUnion(one, {0.02, Vec3::UnitY()}, 0.06).value == Approx(0.01));
  CHECK(smoothIntersection(one, {0.02, Vec3::UnitY()}, 0.06).value == Approx(0.03));
}

TEST_CASE("a limb said to be further than a distance is") {
  const Limb limb = taperedLimb(kA, kB, 0.08, 0.05, Vec3::UnitZ(), 0.6);
  const Positions points = randomPositions(500, 5);
  int further = 0;
  for (int i = 0; i < points.rows(); ++i) {
    const Vec3 x = points.row(i).transpose();
    if (!isFurther(limb, x, 0.2)) continue;
    ++further;
    CHECK(limbDistance(limb, x).value > 0.2);
  }
  CHECK(further > 100);
}
