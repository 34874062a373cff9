#include "solver/energy/stretch.h"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

namespace {

const Spring kSpring{800.0, 1.0};

}  // namespace

TEST_CASE("an unstretched direction costs nothing") {
  CHECK(stretchEnergy({0.0, 1.0, 0.0}, kSpring) == 0.0);
  CHECK(stretchGradient({0.0, 0.6, 0.8}, kSpring).norm() < 1e-12);
}

TEST_CASE("the stretch gradient is the derivative of the energy, stretched and compressed") {
  for (const double length : {0.3, 0.9, 1.4}) {
    const Vec3 f = length * Vec3(0.3, -0.5, 0.8).normalized();
    const Vec3 gradient = stretchGradient(f, kSpring);
    REQUIRE(gradient.norm() > 1.0);
    for (int i = 0; i < 3; ++i) {
      const double difference =
          centralDifference([&](double e) { return stretchEnergy(f + e * Vec3::Unit(i), kSpring); }, 1e-5);
      CHECK(difference == Approx(gradient[i]).margin(1e-8 * kSpring.k));
    }
  }
}

TEST_CASE("the stretch Hessian is the derivative of the gradient where stretched") {
  const Vec3 f(0.4, -0.9, 0.7);
  const Mat3 hessian = stretchHessian(f, kSpring);
  for (int i = 0; i < 3; ++i) {
    const Vec3 difference =
        (stretchGradient(f + 1e-5 * Vec3::Unit(i), kSpring) - stretchGradient(f - 1e-5 * Vec3::Unit(i), kSpring)) /
        2e-5;
    CHECK((difference - hessian.col(i)).norm() < 1e-6 * kSpring.k);
  }
}

TEST_CASE("the stretch Hessian has no negative part where compressed, and keeps the positive one") {
  const Vec3 f(0.0, 0.5, 0.0);
  const Mat3 hessian = stretchHessian(f, kSpring);
  CHECK(hessian(1, 1) == Approx(kSpring.k));
  CHECK(hessian(0, 0) == 0.0);
  CHECK(Eigen::SelfAdjointEigenSolver<Mat3>(hessian).eigenvalues().minCoeff() >= -1e-12);
}

TEST_CASE("damping adds the force of the condition's rate") {
  const double damping_over_h = 300.0, start = 1.2, length = 1.1;
  const Spring with = damped(kSpring, damping_over_h, start);
  const Vec3 f(length, 0.0, 0.0);
  const double expected = kSpring.k * (length - 1.0) + damping_over_h * (length - start);
  CHECK(stretchGradient(f, with)[0] == Approx(expected).epsilon(1e-12));
}
