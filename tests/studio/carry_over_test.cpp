#include "apps/studio/carry_over.h"

#include <catch2/catch.hpp>

#include "tests/tube.h"

namespace ease {
namespace {

TEST_CASE("a longer tube follows the turned tube that it was") {
  TriangleMesh made = tube(24, 13, 3.0), longer = tube(24, 21, 5.0);
  made.positions *= 0.1;
  longer.positions *= 0.1;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.2, Vec3(1, 0, 0)).toRotationMatrix();
  const auto turned = [&](const Positions& x) { return Positions(x * turn.transpose()); };
  const std::vector<double> ratio(made.triangles.rows(), 1.21);
  const CarriedCloth carried = carryOver(made, turned(made.positions), Positions::Zero(made.positions.rows(), 3), ratio,
                                         longer, buildTopology(longer, "tube"));
  CHECK(carried.tied > longer.positions.rows() / 2);
  CHECK(carried.tied < longer.positions.rows());
  CHECK((carried.positions - turned(longer.positions)).rowwise().norm().maxCoeff() < 2e-3);
  int grown = 0;
  for (const double growth : carried.growth) grown += growth == Approx(1.1) ? 1 : 0;
  CHECK(grown > longer.triangles.rows() / 2);
}

}  // namespace
}  // namespace ease
