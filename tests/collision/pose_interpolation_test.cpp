#include "collision/pose_interpolation.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <filesystem>

#include "solver/mesh/mesh_io.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

// A closed box of a limb along x from 0 to 1, bent at x = 0.5 about the z axis by `angle`, smoothly.
TriangleMesh makeLimb(double angle) {
  const int around = 12, along = 30;
  TriangleMesh limb;
  limb.positions.resize(around * (along + 1) + 2, 3);
  const auto bend = [&](double x, double y, double z) {
    const double s = std::clamp((x - 0.35) / 0.3, 0.0, 1.0);
    const Mat3 R = Eigen::AngleAxisd(angle * s * s * (3.0 - 2.0 * s), Vec3::UnitZ()).toRotationMatrix();
    return Vec3(Vec3(0.5, 0.0, 0.0) + R * Vec3(x - 0.5, y, z));
  };
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double a = 2.0 * M_PI * i / around, x = static_cast<double>(j) / along;
      limb.positions.row(j * around + i) = bend(x, 0.05 * std::cos(a), 0.05 * std::sin(a));
    }
  const int first = around * (along + 1), last = first + 1;
  limb.positions.row(first) = bend(-0.02, 0.0, 0.0);
  limb.positions.row(last) = bend(1.02, 0.0, 0.0);
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

double largestMove(const Positions& a, const Positions& b) {
  return (a - b).rowwise().norm().maxCoeff();
}

}  // namespace

TEST_CASE("both poses come out at their ends, to a nanometre") {
  const TriangleMesh from = makeLimb(0.0), to = makeLimb(1.5);
  PoseInterpolation interpolation(from.triangles, from.positions, to.positions);
  Positions x;
  interpolation.at(1e-13, x);
  CHECK(largestMove(x, from.positions) < 1e-9);
  interpolation.at(1.0 - 1e-13, x);
  CHECK(largestMove(x, to.positions) < 1e-9);
}

TEST_CASE("the real poses come out at their ends, to a nanometre") {
  const std::filesystem::path avatars = std::filesystem::path(EASE_SHARED_DATA) / "avatars";
  if (!std::filesystem::exists(avatars)) {
    WARN("skipped: no scans beside the checkout");
    return;
  }
  const TriangleMesh from = readMesh(avatars / "slim_a_pose.ply"), to = readMesh(avatars / "belly_arms_up.ply");
  PoseInterpolation interpolation(from.triangles, from.positions, to.positions);
  Positions x;
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

TEST_CASE("a rigid turn in between is rigid: half of it is half the turn") {
  const TriangleMesh from = makeLimb(0.4);
  const Mat3 R = Eigen::AngleAxisd(2.0, Vec3(1.0, 1.0, 0.0).normalized()).toRotationMatrix();
  const Mat3 half = Eigen::AngleAxisd(1.0, Vec3(1.0, 1.0, 0.0).normalized()).toRotationMatrix();
  PoseInterpolation interpolation(from.triangles, from.positions, from.positions * R.transpose());
  Positions x;
  interpolation.at(0.5, x);
  Positions expected = from.positions * half.transpose();
  expected.rowwise() += (x.row(0) - expected.row(0));
  CHECK(largestMove(x, expected) < 1e-9);
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
