#include "solver/energy/friction.h"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "tests/differences.h"

using namespace ease;

namespace {

constexpr double kSlip = 2e-3;  // slip length, m

/// Slips below and above the slip length, m.
const std::vector<double> kSlips = {1e-4, 1e-3, 1.9e-3, 2.5e-3, 3e-2};

Vec3 tangential(const Vec3& d, const Vec3& normal) {
  return d - normal * normal.dot(d);
}

}  // namespace

TEST_CASE("friction's force and stiffness are derivatives of its potential, below the slip length and above") {
  const Vec3 normal = Vec3(0.2, -0.3, 1.0).normalized();
  const Vec3 along = tangential(Vec3(1.0, 0.4, 0.0), normal).normalized();
  for (const double y : kSlips) {
    const auto force = [&](const Vec3& u) -> Vec3 { return frictionWeight(u.norm(), kSlip) * u; };
    const Mat3 hessian = frictionHessian(y * along, normal, kSlip, HessianKind::exact);
    for (const Vec3& d : {Vec3(0.3, 0.1, -0.5), Vec3(-0.6, 0.2, 0.1)}) {
      const Vec3 t = tangential(d, normal);
      const auto energy = [&](double e) { return frictionPotential((y * along + e * t).norm(), kSlip); };
      const auto moved = [&](double e) { return force(y * along + e * t); };
      CHECK(sharpDifference(energy, 0.05 * y) == Approx(force(y * along).dot(d)).epsilon(1e-9));
      CHECK((sharpDifference(moved, 0.05 * y) - hessian * d).norm() < 1e-8 * (hessian * d).norm());
    }
  }
}

TEST_CASE("without slip friction has no force, far above the slip length that of Coulomb") {
  CHECK(frictionPotential(0.0, kSlip) == 0.0);
  CHECK(frictionWeight(0.0, kSlip) == Approx(2.0 / kSlip));
  CHECK(5.0 * frictionWeight(5.0, kSlip) == Approx(1.0).epsilon(1e-15));
  CHECK(frictionPotential(5.0, kSlip) == Approx(5.0 - kSlip / 3.0).epsilon(1e-15));
}

TEST_CASE("potential, force and stiffness of friction are continuous at the slip length") {
  const double below = kSlip * (1.0 - 1e-9), above = kSlip * (1.0 + 1e-9);
  CHECK(frictionPotential(below, kSlip) == Approx(frictionPotential(above, kSlip)).epsilon(1e-8));
  CHECK(frictionWeight(below, kSlip) == Approx(frictionWeight(above, kSlip)).epsilon(1e-8));
  const Vec3 along = Vec3::UnitX();
  const auto stiffness = [&](double y) {
    return frictionHessian(y * along, Vec3::UnitZ(), kSlip, HessianKind::exact)(0, 0);
  };
  CHECK(std::abs(stiffness(below) - stiffness(above)) < 1e-8 / kSlip);
}

TEST_CASE("eight lanes of friction equal one sample at a time") {
  Lanes y;
  y << 0.0, 1e-9, 1e-4, 1e-3, 2e-3, 2.5e-3, 0.1, 7.0;
  const Lanes potential = frictionPotential(y, kSlip), weight = frictionWeight(y, kSlip);
  for (int l = 0; l < kLanes; ++l) {
    CHECK(potential[l] == Approx(frictionPotential(double(y[l]), kSlip)).epsilon(1e-14));
    CHECK(weight[l] == Approx(frictionWeight(double(y[l]), kSlip)).epsilon(1e-14));
  }
}

TEST_CASE("friction's Hessian is positive semi-definite and at most its bound, tangential both") {
  const Vec3 normal = Vec3(0.2, -0.3, 1.0).normalized();
  const auto least = [](const Mat3& m) {
    return Eigen::SelfAdjointEigenSolver<Mat3>(m, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
  };
  for (const double y : {0.0, 1e-4, 1.9e-3, 3e-2}) {
    const Vec3 u = y * tangential(Vec3(1.0, 0.4, 0.0), normal).normalized();
    const Mat3 exact = frictionHessian(u, normal, kSlip, HessianKind::exact);
    const Mat3 bound = frictionHessian(u, normal, kSlip, HessianKind::projected);
    CHECK(least(exact) > -1e-12 / kSlip);
    CHECK(least(bound - exact) > -1e-12 / kSlip);
    CHECK((exact * normal).norm() < 1e-12 / kSlip);
    CHECK((bound * normal).norm() < 1e-12 / kSlip);
  }
}

TEST_CASE("the quadratic with friction's weight at one slip bounds the potential at every other") {
  for (const double here : kSlips)
    for (const double there : kSlips) {
      const double weight = frictionWeight(here, kSlip);
      const double bound = frictionPotential(here, kSlip) + 0.5 * weight * (there * there - here * here);
      CHECK(bound >= frictionPotential(there, kSlip) * (1.0 - 1e-12));
    }
}
