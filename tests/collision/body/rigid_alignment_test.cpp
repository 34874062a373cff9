#include "collision/body/rigid_alignment.h"

#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

TEST_CASE("a body that turned about the vertical and moved is brought back to where it stood") {
  const Positions from = randomPositions(40, 3);
  for (const double angle : {0.3, 3.0, -2.0}) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
    Positions to = (from * turn.transpose()).rowwise() + Eigen::RowVector3d(4.0, 1.0, -2.0);
    const Standing standing = standingBetween(from, to);
    CHECK(standing.turn_rad == Approx(angle));
    standAs(standing, to);
    CHECK((to - from).cwiseAbs().maxCoeff() < 1e-12);
  }
}
