#include "solver/energy/stretch.h"

#include <catch2/catch.hpp>

using namespace ease;

TEST_CASE("a stretched thread pulls along itself by stiffness times excess, a compressed one pushes") {
  for (const double length : {0.7, 1.0, 1.3}) {
    const Vec3 along = Vec3(1.0, -2.0, 0.5).normalized(), f = length * along;
    Column<double> stress{0.0, 0.0, 0.0};
    const double energy = addStretch(Column<double>{f.x(), f.y(), f.z()}, 800.0, 1.0, stress);
    CHECK(energy == Approx(400.0 * (length - 1.0) * (length - 1.0)).margin(1e-12));
    CHECK((Vec3(stress.x, stress.y, stress.z) - 800.0 * (length - 1.0) * along).norm() < 1e-12);
  }
}

TEST_CASE("a thread of no length has no direction and no force") {
  Column<double> stress{0.0, 0.0, 0.0};
  CHECK(addStretch(Column<double>{0.0, 0.0, 0.0}, 800.0, 1.0, stress) == 400.0);
  CHECK(dot(stress, stress) == 0.0);
  CHECK(stretchHessian(Vec3::Zero(), {800.0, 1.0}, HessianKind::exact).norm() == 0.0);
}

TEST_CASE("across a thread its tension stiffens, and its push is left out of the projected Hessian") {
  const Spring spring{800.0, 1.0};
  const Vec3 along = Vec3::UnitX(), across = Vec3::UnitY();
  const auto stiffness = [&](double length, HessianKind kind, const Vec3& direction) {
    return direction.dot(stretchHessian(length * along, spring, kind) * direction);
  };
  for (const HessianKind kind : {HessianKind::exact, HessianKind::projected}) {
    CHECK(stiffness(1.6, kind, along) == Approx(800.0));
    CHECK(stiffness(0.4, kind, along) == Approx(800.0));
    CHECK(stiffness(1.6, kind, across) == Approx(800.0 * 0.6 / 1.6));
  }
  CHECK(stiffness(0.4, HessianKind::exact, across) == Approx(-800.0 * 0.6 / 0.4));
  CHECK(stiffness(0.4, HessianKind::projected, across) == 0.0);
}

TEST_CASE("a softened thread pushes less and pulls as hard") {
  const double softening = 760.0;
  const auto force = [&](double length) {
    Column<double> stress{0.0, 0.0, 0.0};
    addStretch(Column<double>{length, 0.0, 0.0}, 800.0, 1.0, stress, softening);
    return stress.x;
  };
  CHECK(force(1.3) == Approx(240.0));
  CHECK(force(0.7) == Approx(-12.0));
  const Mat3 slack = stretchHessian(0.7 * Vec3::UnitX(), {800.0, 1.0}, HessianKind::exact, softening);
  CHECK(slack(0, 0) == Approx(40.0));
  CHECK(slack(1, 1) == Approx(-12.0 / 0.7));
}

TEST_CASE("damping adds the force of the condition's rate") {
  const double damping_over_h = 300.0, start = 1.2, now = 1.1;
  const Spring with = damped({800.0, 1.0}, damping_over_h, start);
  Column<double> stress{0.0, 0.0, 0.0};
  addStretch(Column<double>{now, 0.0, 0.0}, with.k, with.c, stress);
  CHECK(stress.x == Approx(800.0 * (now - 1.0) + damping_over_h * (now - start)).epsilon(1e-12));
}

TEST_CASE("damping alone, without a spring, pulls back to where the step began, without either there is nothing") {
  const Spring damper = damped({0.0, 1.0}, 300.0, 1.2);
  CHECK(damper.k == 300.0);
  CHECK(damper.c == Approx(1.2));
  const Spring nothing = damped({0.0, 1.0}, 0.0, 1.2);
  CHECK(nothing.k == 0.0);
  CHECK(nothing.c == 0.0);
}
