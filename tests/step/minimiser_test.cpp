#include "solver/step/minimiser.h"

#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

namespace {

/// A sheet that moves without deforming. Only inertia and gravity act, so the potential is a parabola.
struct Falling {
  TriangleMesh mesh = makeSheet(4, 3, 0.2, 0.15);
  Cloth cloth{mesh, -Vec3::UnitY(), Material()};
  IncrementalPotential potential{cloth};
  std::vector<char> fixed;
  StepOptions options;
  Point point;

  explicit Falling(const Vec3& velocity = Vec3::Zero(), const Vec3& gravity = {0.0, -9.81, 0.0})
      : fixed(cloth.vertexCount(), 0) {
    options.gravity = gravity;
    State start{mesh.positions, Positions::Zero(cloth.vertexCount(), 3)};
    start.velocities.rowwise() += velocity.transpose();
    potential.begin(start, options);
    moveTo(Vec3::Zero());
  }
  /// Moves the point to the start of the step plus `shift`, m.
  void moveTo(const Vec3& shift) {
    point.x = mesh.positions + all(shift);
    point.evaluate(potential, fixed);
  }
  int search(const Positions& direction, Point& next) {
    return searchAlong(potential, fixed, point, direction, point.gradient.cwiseProduct(direction).sum(), next);
  }
  Positions all(const Vec3& shift) const {
    return Eigen::RowVector3d(shift.transpose()).replicate(cloth.vertexCount(), 1);
  }
};

const Vec3 kFall(0.0, -9.81 * 0.0025 * 0.0025, 0.0);  // fall in the first step, m

}  // namespace

TEST_CASE("a point has the potential and its gradient, where vertices are pinned the gradient is zero") {
  Falling falling;
  falling.fixed[3] = 1;
  falling.moveTo({0.01, 0.0, 0.02});
  Positions gradient(falling.cloth.vertexCount(), 3);
  CHECK(falling.point.energy == falling.potential.gradient(falling.point.x, gradient));
  REQUIRE(gradient.row(3).norm() > 1e-6);
  gradient.row(3).setZero();
  CHECK(falling.point.gradient == gradient);
}

TEST_CASE("the residual acceleration at the start of a step from rest is gravity, and none where the fall ends") {
  Falling falling;
  REQUIRE(falling.options.h == 0.0025);
  CHECK(residualAcceleration(falling.potential, falling.point) == Approx(9.81).epsilon(1e-9));
  falling.moveTo(kFall);
  CHECK(residualAcceleration(falling.potential, falling.point) < 1e-6);
  falling.point.gradient.row(5) = falling.cloth.masses()[5] * Eigen::RowVector3d(3.0, 0.0, 4.0);
  CHECK(residualAcceleration(falling.potential, falling.point) == Approx(5.0).epsilon(1e-9));
}

TEST_CASE("a correction is measured by how far the step moves the cloth, or by what forces add to that, four times") {
  const Vec3 moved(0.01, 0.0, 0.0), direction(0.0, 0.0, 2e-4);
  Falling from_rest(Vec3::Zero(), Vec3::Zero());
  from_rest.moveTo(moved);
  CHECK(relativeLength(from_rest.potential, from_rest.point, from_rest.all(direction)) == Approx(0.02).epsilon(1e-6));
  // At 3.6 m/s the step moves the sheet by 9 mm without any force, so of these 10 mm forces add 1 mm.
  Falling fast({3.6, 0.0, 0.0}, Vec3::Zero());
  fast.moveTo(moved);
  CHECK(relativeLength(fast.potential, fast.point, fast.all(direction)) == Approx(0.2 / 4.0).epsilon(1e-4));
  for (const Falling* falling :
       {&from_rest, &fast}) {  // with inertia alone, decrement and length of Newton's step are equal
    const double slope = -falling->potential.kinetic(falling->all(direction));
    CHECK(relativeDecrement(falling->potential, falling->point, slope) ==
          Approx(relativeLength(falling->potential, falling->point, falling->all(direction))).epsilon(1e-12));
  }
  CHECK(relativeDecrement(fast.potential, fast.point, 1e-3) == 0.0);  // uphill
}

TEST_CASE("a correction of a cloth that hardly moves is compared with a millimetre per second") {
  Falling still(Vec3::Zero(), Vec3::Zero());
  const Vec3 direction(1e-3 * still.options.h, 0.0, 0.0);
  CHECK(relativeLength(still.potential, still.point, still.all(direction)) == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("a search goes all the way where that is downhill, else halves until it is") {
  Falling falling;
  Point next;
  const double floor = [&] {
    Falling fallen;
    fallen.moveTo(kFall);
    return fallen.point.energy;
  }();
  for (const int halvings : {0, 1, 2, 5}) {
    const Positions direction =
        falling.all(std::pow(2.0, halvings) * kFall);  // 2^halvings times the way to the minimum
    CHECK(falling.search(direction, next) == halvings);
    CHECK((next.x - falling.point.x - falling.all(kFall)).norm() < 1e-12);
    CHECK(next.energy == Approx(floor).margin(1e-9 * falling.point.energy));
    CHECK(next.energy < falling.point.energy);
  }
  const Positions short_way = falling.all(0.3 * kFall);
  CHECK(falling.search(short_way, next) == 0);
  CHECK((next.x - falling.point.x - short_way).norm() < 1e-15);
}

TEST_CASE("a search uphill finds nothing") {
  Falling falling;
  Point next;
  CHECK(falling.search(falling.all(-kFall), next) == -1);
}
