#include "collision/level_set.h"

#include <oneapi/tbb/task_arena.h>

#include <catch2/catch.hpp>
#include <limits>

#include "solver/base/error.h"
#include "tests/collision/bodies.h"

using namespace ease;
using namespace ease::bodies;

namespace {

TriangleTree treeOf(const TriangleMesh& mesh) {
  return TriangleTree(mesh.positions, mesh.triangles);
}

std::vector<LevelSetSample> sampled(LevelSet& level_set, const std::vector<Vec3>& points) {
  std::vector<LevelSetSample> samples(points.size());
  level_set.sample(points, samples);
  return samples;
}

std::vector<LevelSetSample> sampled(const TriangleTree& body, const std::vector<Vec3>& points,
                                    const LevelSetOptions& options = {}) {
  LevelSet level_set(options);
  level_set.build(body, points, 0.3 * options.voxel);
  return sampled(level_set, points);
}

bool same(const std::vector<LevelSetSample>& a, const std::vector<LevelSetSample>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const LevelSetSample& s, const LevelSetSample& t) {
    return s.phi == t.phi && s.normal == t.normal && s.triangle == t.triangle;
  });
}

/// Points within `reach` of the unit sphere's surface scaled to `radius`.
std::vector<Vec3> shell(double radius, double reach, int count) {
  std::vector<Vec3> points;
  for (const Vec3& x : pointsIn(Vec3::Constant(-radius - reach), Vec3::Constant(radius + reach), count))
    if (std::abs(x.norm() - radius) < reach) points.push_back(x);
  return points;
}

TriangleMesh twoSpheres(double offset, double radius, int rings) {
  const TriangleMesh ball = sphere(radius, rings);
  return joined(moved(ball, Vec3(offset, 0.0, 0.0)), moved(ball, Vec3(-offset, 0.0, 0.0)));
}

}  // namespace

TEST_CASE("distance and normal of a sphere, inside and outside") {
  const double radius = 0.2;
  const TriangleTree body = treeOf(sphere(radius, 48));
  const std::vector<Vec3> points = shell(radius, 0.02, 20000);
  const std::vector<LevelSetSample> samples = sampled(body, points);
  REQUIRE(points.size() > 1000);
  for (size_t i = 0; i < points.size(); ++i) {
    CHECK(std::abs(samples[i].phi - (points[i].norm() - radius)) < 2e-4);
    CHECK(samples[i].normal.dot(points[i].normalized()) > 0.99);
    CHECK(samples[i].normal.norm() == Approx(1.0).epsilon(1e-12));
    CHECK(samples[i].triangle >= 0);
  }
}

TEST_CASE("distance to a capsule, inside and outside") {
  const double half_length = 0.2, radius = 0.06;
  const TriangleTree body = treeOf(capsule(half_length, radius, 32));
  const std::vector<Vec3> points = pointsIn(Vec3(-0.08, -0.28, -0.08), Vec3(0.08, 0.28, 0.08), 5000);
  const std::vector<LevelSetSample> samples = sampled(body, points);
  for (size_t i = 0; i < points.size(); ++i) {
    const double expected = distanceToCapsule(points[i], half_length, radius);
    if (std::abs(expected) < 0.02) CHECK(std::abs(samples[i].phi - expected) < 6e-4);
  }
}

TEST_CASE("distance to a box is exact but near its edges") {
  const Vec3 low = Vec3::Constant(-0.1), high = Vec3::Constant(0.1);
  const TriangleTree body = treeOf(box(low, high));
  const std::vector<Vec3> points = pointsIn(Vec3(-0.12, -0.05, -0.05), Vec3(-0.08, 0.05, 0.05), 1000);
  const std::vector<LevelSetSample> samples = sampled(body, points);
  for (size_t i = 0; i < points.size(); ++i) {
    CHECK(samples[i].phi == Approx(distanceToBox(points[i], low, high)).margin(1e-8));
    CHECK((samples[i].normal - Vec3(-1.0, 0.0, 0.0)).norm() < 1e-5);
  }
}

TEST_CASE("on a sphere the error falls faster than the square of the voxel, as long as no facets show") {
  const double radius = 0.4;
  const TriangleTree body = treeOf(sphere(radius, 128));
  const std::vector<Vec3> points = shell(radius, 0.03, 10000);
  std::vector<double> log_voxel, log_error;
  for (double voxel : {0.16, 0.12, 0.1}) {
    const std::vector<LevelSetSample> samples = sampled(body, points, {.voxel = voxel, .band = 0.3});
    double squared = 0.0;
    for (size_t i = 0; i < points.size(); ++i)
      squared += std::pow(samples[i].phi - body.signedDistance(points[i], 1.0), 2);
    log_voxel.push_back(std::log(voxel));
    log_error.push_back(0.5 * std::log(squared / points.size()));
  }
  const double slope = (log_error.front() - log_error.back()) / (log_voxel.front() - log_voxel.back());
  CHECK(slope > 2.3);
  CHECK(slope < 3.5);
}

TEST_CASE("two overlapping spheres: right sign in the overlap and near the seam") {
  const double offset = 0.08, radius = 0.12;
  const TriangleTree body = treeOf(twoSpheres(offset, radius, 24));
  const std::vector<Vec3> points = pointsIn(Vec3(-0.06, -0.14, -0.14), Vec3(0.06, 0.14, 0.14), 5000);
  LevelSet level_set(LevelSetOptions{});
  level_set.build(body, points, 0.003);
  CHECK(level_set.overlappingTriangles() > 0);
  const std::vector<LevelSetSample> samples = sampled(level_set, points);
  for (size_t i = 0; i < points.size(); ++i) {
    const double expected = distanceToTwoSpheres(points[i], offset, radius);
    if (std::abs(expected) > 0.002) CHECK((samples[i].phi < 0.0) == (expected < 0.0));
    if (expected > 0.0) CHECK(samples[i].phi == Approx(std::min(expected, 0.03)).margin(0.004));
  }
}

TEST_CASE("corners that were not foreseen get the same values as those that were") {
  for (const TriangleMesh& mesh : {sphere(0.12, 16), twoSpheres(0.08, 0.12, 16)}) {
    const TriangleTree body = treeOf(mesh);
    const std::vector<Vec3> points = pointsIn(Vec3::Constant(-0.2), Vec3::Constant(0.2), 3000);
    LevelSet foreseen(LevelSetOptions{}), unforeseen(LevelSetOptions{});
    foreseen.build(body, points, 0.005);
    unforeseen.build(body, {}, 0.005);
    CHECK(unforeseen.filledVoxels() == 0);
    CHECK(same(sampled(foreseen, points), sampled(unforeseen, points)));
    CHECK(foreseen.filledOnDemand() == 0);
    CHECK(unforeseen.filledOnDemand() == unforeseen.filledVoxels());
    CHECK(unforeseen.filledVoxels() > 0);
    CHECK(same(sampled(foreseen, points), sampled(unforeseen, points)));
  }
}

TEST_CASE("one thread and two give the same to the last bit") {
  const TriangleMesh mesh = twoSpheres(0.08, 0.12, 16);
  const std::vector<Vec3> points = pointsIn(Vec3::Constant(-0.2), Vec3::Constant(0.2), 5000);
  const std::vector<Vec3> some(points.begin(), points.begin() + 2500);
  std::vector<LevelSetSample> by_threads[2];
  for (int threads : {1, 2})
    tbb::task_arena(threads).execute([&] {
      const TriangleTree body = treeOf(mesh);
      LevelSet level_set(LevelSetOptions{});
      level_set.build(body, some, 0.003);
      by_threads[threads - 1] = sampled(level_set, points);
      CHECK(level_set.filledOnDemand() > 0);
    });
  CHECK(same(by_threads[0], by_threads[1]));
}

TEST_CASE("a level set built again on the moved body is that of a new one") {
  const TriangleMesh first = sphere(0.12, 16), second = moved(first, Vec3(0.05, 0.02, -0.03));
  const std::vector<Vec3> points = pointsIn(Vec3::Constant(-0.2), Vec3::Constant(0.2), 3000);
  TriangleTree body = treeOf(first);
  LevelSet level_set(LevelSetOptions{});
  level_set.build(body, points, 0.003);
  const std::vector<LevelSetSample> before = sampled(level_set, points);
  body.refit(second.positions);
  level_set.build(body, points, 0.003);
  CHECK(same(sampled(level_set, points), sampled(treeOf(second), points)));
  CHECK(!same(sampled(level_set, points), before));
}

TEST_CASE("half way between two surfaces the normal is one of theirs") {
  const Vec3 low = Vec3::Constant(-0.1), high = Vec3::Constant(0.1), shift(0.212, 0.0, 0.0);
  const TriangleTree body = treeOf(joined(box(low, high), moved(box(low, high), shift)));
  const std::vector<Vec3> points = pointsIn(Vec3(0.1055, -0.05, -0.05), Vec3(0.1065, 0.05, 0.05), 500);
  for (const LevelSetSample& s : sampled(body, points)) {
    CHECK(std::abs(std::abs(s.normal[0]) - 1.0) < 1e-6);
    CHECK(s.phi > 0.0);
    CHECK(s.phi < 0.0061);
    CHECK(s.triangle >= 0);
  }
}

TEST_CASE("exactly on the surface the distance is zero and the normal is the surface's") {
  const TriangleTree body = treeOf(box(Vec3::Constant(-0.125), Vec3::Constant(0.125)));
  const std::vector<Vec3> points = {{0.125, 0.0, 0.0}, {0.0, -0.125, 0.015625}, {0.125, 0.125, 0.125}};
  const std::vector<LevelSetSample> samples = sampled(body, points, {.voxel = 0.015625, .band = 0.05});
  for (const LevelSetSample& s : samples) CHECK(std::abs(s.phi) < 1e-9);
  CHECK((samples[0].normal - Vec3(1.0, 0.0, 0.0)).norm() < 1e-6);
  CHECK((samples[1].normal - Vec3(0.0, -1.0, 0.0)).norm() < 1e-6);
  CHECK((samples[2].normal - Vec3::Ones().normalized()).norm() < 1e-6);
}

TEST_CASE("beyond the band the sign is still right, however deep") {
  const TriangleTree body = treeOf(twoSpheres(0.08, 0.12, 16));
  const std::vector<Vec3> points = {{0.0, 0.0, 0.0}, {0.08, 0.0, 0.0},  {0.1, 0.01, 0.02},
                                    {0.3, 0.3, 0.3}, {1e30, 0.0, -5.0}, {0.0, 0.17, 0.0}};
  const std::vector<LevelSetSample> samples = sampled(body, points);
  for (size_t i = 0; i < points.size(); ++i) {
    CHECK(samples[i].phi == (i < 3 ? -0.03 : 0.03));
    CHECK(samples[i].normal.isZero());
    CHECK(samples[i].triangle == -1);
  }
}

TEST_CASE("points out of the body's reach cost no voxels") {
  const TriangleTree body = treeOf(sphere(0.1, 8));
  LevelSet level_set(LevelSetOptions{});
  const std::vector<Vec3> points = {{5.0, 0.0, 0.0}, {0.0, 1e9, 0.0}};
  level_set.build(body, points, 0.003);
  sampled(level_set, points);
  CHECK(level_set.filledVoxels() == 0);
}

TEST_CASE("points that are no numbers are refused by name") {
  const TriangleTree body = treeOf(sphere(0.1, 8));
  LevelSet level_set(LevelSetOptions{});
  std::vector<Vec3> points(3, Vec3::Constant(0.1));
  level_set.build(body, points, 0.003);
  points[2][1] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(sampled(level_set, points), "level set: sample 2 is not finite");
  CHECK_THROWS_WITH(level_set.build(body, points, 0.003), "level set: point 2 is not finite");
}

TEST_CASE("options out of range are refused with their value") {
  CHECK_THROWS_WITH(LevelSet({.voxel = 0.0, .band = 0.03}), "level set: voxel = 0 m, must be positive");
  CHECK_THROWS_WITH(LevelSet({.voxel = 0.02, .band = -0.03}), "level set: band = -0.03 m, must be positive");
}
