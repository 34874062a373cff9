#include "solver/energy/shear.h"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

namespace {

const Spring kSpring{200.0, 0.0};

Mat32 someGradient(double scale) {
  Mat32 F;
  F << 0.9, 0.5, 0.1, 0.8, -0.4, 0.3;
  return scale * F;
}

Eigen::Matrix<double, 6, 6> whole(const FrameHessian& h) {
  Eigen::Matrix<double, 6, 6> H;
  H << h.uu, h.uv, h.uv.transpose(), h.vv;
  return H;
}

Eigen::Matrix<double, 6, 1> flat(const Mat32& P) {
  return P.reshaped();
}

}  // namespace

TEST_CASE("orthogonal columns of any length cost nothing") {
  Mat32 F;
  F << 1.3, 0.0, 0.0, 0.7, 0.0, 0.0;
  CHECK(shearEnergy(F, kSpring) < 1e-25);
  CHECK(shearGradient(F, kSpring).norm() < 1e-12);
}

TEST_CASE("shear equals the squared cosine condition to second order") {
  for (const double angle : {1e-2, 1e-3}) {
    Mat32 F;
    F << 1.0, std::sin(angle), 0.0, std::cos(angle), 0.0, 0.0;
    const double cosine = F.col(0).dot(F.col(1));
    CHECK(shearEnergy(F, kSpring) == Approx(0.5 * kSpring.k * cosine * cosine).epsilon(angle * angle));
  }
}

TEST_CASE("shear is twice the squared distance to the nearest orthogonal pair") {
  // Closed form 2 dist^2 = A - sqrt(A^2 - 4 D^2), A = |f_u|^2 + |f_v|^2, D = f_u . f_v.
  const Mat32 F = someGradient(1.0);
  const double A = F.squaredNorm(), D = F.col(0).dot(F.col(1));
  CHECK(shearEnergy(F, kSpring) == Approx(0.5 * kSpring.k * (A - std::sqrt(A * A - 4.0 * D * D))).epsilon(1e-12));
}

TEST_CASE("the shear gradient is the derivative of the energy") {
  for (const double scale : {0.4, 1.0, 1.6})
    for (const Spring& spring : {kSpring, Spring{200.0, 0.3}}) {
      const Mat32 F = someGradient(scale);
      const Mat32 gradient = shearGradient(F, spring);
      REQUIRE(gradient.norm() > 1e-2);
      for (int k = 0; k < 6; ++k) {
        const auto energy = [&](double e) {
          Mat32 moved = F;
          moved.reshaped()[k] += e;
          return shearEnergy(moved, spring);
        };
        CHECK(centralDifference(energy, 1e-5) == Approx(gradient.reshaped()[k]).margin(1e-8 * spring.k));
      }
    }
}

TEST_CASE("the shear Hessian is the derivative of the gradient, less its negative part") {
  for (const Spring& spring : {kSpring, Spring{200.0, 0.9}}) {
    const Mat32 F = someGradient(1.0);
    Eigen::Matrix<double, 6, 6> exact;
    for (int k = 0; k < 6; ++k) {
      Mat32 up = F, down = F;
      up.reshaped()[k] += 1e-5;
      down.reshaped()[k] -= 1e-5;
      exact.col(k) = (flat(shearGradient(up, spring)) - flat(shearGradient(down, spring))) / 2e-5;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(0.5 * (exact + exact.transpose()));
    REQUIRE(eigen.eigenvalues().minCoeff() < -1.0);
    const Eigen::Matrix<double, 6, 6> projected =
        eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() * eigen.eigenvectors().transpose();
    CHECK((whole(shearHessian(F, spring)) - projected).norm() < 1e-6 * spring.k);
  }
}
