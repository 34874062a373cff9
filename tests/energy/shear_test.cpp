#include "solver/energy/shear.h"

#include <catch2/catch.hpp>

#include "tests/energy/elements.h"

using namespace ease;

TEST_CASE("both shears equal the squared cosine to second order, and the orthogonal one a distance exactly") {
  for (const double angle : {1e-2, 1e-3}) {
    Mat32 F;
    F << 1.0, std::sin(angle), 0.0, std::cos(angle), 0.0, 0.0;
    const double cosine = F.col(0).dot(F.col(1));
    for (const Element& element : {elementNamed("orthogonal shear"), elementNamed("bw98 shear")})
      CHECK(element.energy(F) == Approx(0.5 * 200.0 * cosine * cosine).epsilon(angle * angle));
  }
  // The squared distance to the nearest matrix with orthogonal columns is dist^2 = (A - sqrt(A^2 - 4 D^2)) / 2, with
  // A = |f_u|^2 + |f_v|^2 and D = f_u . f_v.
  const Mat32 F = someGradient(1.0);
  const double A = F.squaredNorm(), D = F.col(0).dot(F.col(1));
  CHECK(elementNamed("orthogonal shear").energy(F) ==
        Approx(0.5 * 200.0 * (A - std::sqrt(A * A - 4.0 * D * D))).epsilon(1e-12));
}

TEST_CASE("cloth whose warp and weft are orthogonal is not sheared, however it is stretched") {
  Mat32 F;
  F << 1.3, 0.0, 0.0, 0.7, 0.0, 0.0;
  const Mat3 turn = Eigen::AngleAxisd(0.8, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  CHECK(std::abs(orthogonalShear(turn * F)) < 1e-15);
  CHECK(std::abs(bw98Shear(turn * F)) < 1e-15);
  for (const Element& element : {elementNamed("orthogonal shear"), elementNamed("bw98 shear")}) {
    INFO(element.name);
    CHECK(element.energy(turn * F) < 1e-25);
    CHECK(element.stress(turn * F).norm() < 1e-12);
  }
}

TEST_CASE("shear has the sign of the cosine, and exchanging warp and weft changes nothing") {
  const Mat32 F = someGradient(1.0);
  Mat32 exchanged, reversed = F;
  exchanged << F.col(1), F.col(0);
  reversed.col(1) *= -1.0;
  REQUIRE(bw98Shear(F) > 0.1);
  CHECK(orthogonalShear(F) > 0.0);
  CHECK(orthogonalShear(exchanged) == orthogonalShear(F));
  CHECK(orthogonalShear(reversed) == -orthogonalShear(F));
}
