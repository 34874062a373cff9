#include "collision/pose_interpolation.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <filesystem>

#include "collision/gradient_interpolation.h"
#include "solver/linear/gradient_system.h"
#include "solver/mesh/mesh_io.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

// A closed limb along x from 0 to 1, each place of it where place(x, y, z) has it.
template <class Place>
TriangleMesh makeLimbAt(const Place& place) {
  const int around = 12, along = 30;
  TriangleMesh limb;
  limb.positions.resize(around * (along + 1) + 2, 3);
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double a = 2.0 * M_PI * i / around, x = static_cast<double>(j) / along;
      limb.positions.row(j * around + i) = place(x, 0.05 * std::cos(a), 0.05 * std::sin(a));
    }
  const int first = around * (along + 1), last = first + 1;
  limb.positions.row(first) = place(-0.02, 0.0, 0.0);
  limb.positions.row(last) = place(1.02, 0.0, 0.0);
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    triangles.push_back({first, next, i});
    triangles.push_back({last, along * around + i, along * around + next});
    for (int j = 0; j < along; ++j) {
      const int a = j * around + i, b = j * around + next;
      triangles.push_back({a, b, a + around});
      triangles.push_back({b, b + around, a + around});
    }
  }
  limb.triangles.resize(static_cast<int>(triangles.size()), 3);
  for (size_t t = 0; t < triangles.size(); ++t)
    limb.triangles.row(static_cast<int>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
  return limb;
}

// Bent at x = 0.5 about the z axis by `angle`, smoothly.
TriangleMesh makeLimb(double angle) {
  return makeLimbAt([&](double x, double y, double z) {
    const double s = std::clamp((x - 0.35) / 0.3, 0.0, 1.0);
    const Mat3 R = Eigen::AngleAxisd(angle * s * s * (3.0 - 2.0 * s), Vec3::UnitZ()).toRotationMatrix();
    return Vec3(Vec3(0.5, 0.0, 0.0) + R * Vec3(x - 0.5, y, z));
  });
}

// Twisted about its axis by `angle` from end to end.
TriangleMesh makeTwistedLimb(double angle) {
  return makeLimbAt(
      [&](double x, double y, double z) { return Vec3(Eigen::AngleAxisd(angle * x, Vec3::UnitX()) * Vec3(x, y, z)); });
}

double largestMove(const Positions& a, const Positions& b) {
  return (a - b).rowwise().norm().maxCoeff();
}

}  // namespace

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

TEST_CASE("the real poses come out at their ends to the last bit, beside them to a nanometre") {
  const std::filesystem::path avatars = std::filesystem::path(EASE_SHARED_DATA) / "avatars";
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

TEST_CASE("a limb turns without a jump and keeps its lengths, also by more than half a turn") {
  for (const double angle : {1.5, 3.0, 3.5}) {
    const TriangleMesh from = makeLimb(0.0), to = makeLimb(angle);
    PoseInterpolation interpolation(from.triangles, from.positions, to.positions);
    Positions x, before;
    interpolation.at(0.0, before);
    const auto edgeLength = [&](const Positions& at) {
      return (at.row(from.triangles(40, 0)) - at.row(from.triangles(40, 1))).norm();
    };
    for (int k = 1; k <= 50; ++k) {
      interpolation.at(k / 50.0, x);
      CHECK(largestMove(x, before) < 0.52 * angle / 50.0 * 1.5);  // no jump: about the arm's length times the turn
      CHECK(edgeLength(x) == Approx(edgeLength(from.positions)).epsilon(0.15));
      before = x;
    }
  }
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

TEST_CASE("an ordering found before serves as well") {
  const TriangleMesh a = makeLimb(0.0), b = makeLimb(1.0);
  PoseInterpolation first(a.triangles, a.positions, b.positions);
  PoseInterpolation second(a.triangles, b.positions, a.positions,
                           systemOrdering(static_cast<int>(a.positions.rows()), a.triangles));
  Positions x;
  second.at(1.0, x);
  CHECK(largestMove(x, a.positions) < 1e-9);
}
