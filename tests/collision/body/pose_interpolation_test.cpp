#include "collision/body/pose_interpolation.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "collision/body/gradient_interpolation.h"
#include "solver/io/mesh_io.h"
#include "solver/mesh/numbering.h"
#include "tests/collision/body/posed_limbs.h"
#include "tests/places.h"

using namespace ease;

TEST_CASE("both poses come out at their ends to the last bit, beside them to a nanometre") {
  const TriangleMesh from = makeLimb(0.0), to = makeLimb(1.5);
  const PoseInterpolation interpolation(from.triangles, from.positions, to.positions);
  Positions x;
  interpolation.at(0.0, x);
  CHECK(x == from.positions);
  interpolation.at(1.0, x);
  CHECK(x == to.positions);
  interpolation.at(1e-13, x);
  CHECK(largestMove(x, from.positions) < 1e-9);
  interpolation.at(1.0 - 1e-13, x);
  CHECK(largestMove(x, to.positions) < 1e-9);
}

TEST_CASE("renumbered, the way through the poses gives the same places in the new order") {
  const TriangleMesh from = makeLimb(0.0), to = makeLimb(1.5), end = makeLimb(0.7);
  const std::vector<Positions> poses = {from.positions, to.positions, end.positions};
  const Numbering numbering = spatialNumbering(from);
  const InterpolatedPoses way(from.triangles, poses), ordered = renumbered(way, numbering.vertices);
  std::vector<int> eliminated;  // in the old numbering
  for (const int vertex : ordered.ordering) eliminated.push_back(numbering.vertices[vertex]);
  CHECK(eliminated == way.ordering);
  REQUIRE(ordered.interpolations.size() == 2);
  for (size_t p = 0; p < 2; ++p) {
    Positions x, y;
    way.interpolations[p].at(0.3, x);
    ordered.interpolations[p].at(0.3, y);
    CHECK(x != y);
    CHECK(x == restored(y, numbering.vertices));
  }
}

TEST_CASE("the real poses come out at their ends to the last bit, beside them to a nanometre") {
  const std::filesystem::path avatars = std::filesystem::path(kSharedData) / "avatars";
  if (!std::filesystem::exists(avatars)) {
    WARN("skipped: no scans beside the checkout");
    return;
  }
  const TriangleMesh from = readMesh(avatars / "slim_a_pose.ply"), to = readMesh(avatars / "belly_arms_up.ply");
  const PoseInterpolation interpolation(from.triangles, from.positions, to.positions);
  Positions x;
  interpolation.at(0.0, x);
  CHECK(x == from.positions);
  interpolation.at(1.0, x);
  CHECK(x == to.positions);
  interpolation.at(1e-13, x);
  CHECK(largestMove(x, from.positions) < 1e-9);
  interpolation.at(1.0 - 1e-13, x);
  CHECK(largestMove(x, to.positions) < 1e-9);
}

TEST_CASE("a rigid turn in between is rigid: a part of it is that part of the turn") {
  const TriangleMesh from = makeLimb(0.4);
  const Vec3 axis = Vec3(1.0, 1.0, 0.0).normalized();
  for (const double angle : {2.0, 170.0 * M_PI / 180.0}) {
    const Mat3 R = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    const PoseInterpolation interpolation(from.triangles, from.positions, from.positions * R.transpose());
    Positions x;
    for (int k = 0; k <= 40; ++k) {
      interpolation.at(k / 40.0, x);
      const Mat3 part = Eigen::AngleAxisd(k / 40.0 * angle, axis).toRotationMatrix();
      Positions expected = from.positions * part.transpose();
      expected.rowwise() += (x.row(0) - expected.row(0));
      CHECK(largestMove(x, expected) < 1e-10);
    }
  }
}

TEST_CASE("the polynomial agrees with poses that are solved for, at its nodes too") {
  std::vector<double> moments;
  for (int k = 0; k <= 100; ++k) moments.push_back(k / 100.0);
  for (int n = 2; n <= 24; ++n)
    for (int j = 1; j < n; ++j) moments.push_back(std::pow(std::sin(0.5 * M_PI * j / n), 2.0));
  const TriangleMesh straight = makeLimb(0.0);
  const Mat3 R = Eigen::AngleAxisd(170.0 * M_PI / 180.0, Vec3::UnitY()).toRotationMatrix();
  const std::vector<Positions> targets{straight.positions, 1.3 * straight.positions, straight.positions * R.transpose(),
                                       makeLimb(3.5).positions, makeTwistedLimb(10.0).positions};
  for (size_t k = 0; k < targets.size(); ++k) {
    GradientInterpolation solved(straight.triangles, straight.positions, targets[k]);
    CHECK((solved.largestTurn() > M_PI) == (k >= 3));  // the last two have been unwound
    const PoseInterpolation interpolation(straight.triangles, straight.positions, targets[k]);
    Positions x, expected;
    double largest = 0.0;
    for (double s : moments) {
      interpolation.at(s, x);
      solved.at(s, expected);
      largest = std::max(largest, largestMove(x, expected));
    }
    CHECK(largest < 1e-10);
  }
}
