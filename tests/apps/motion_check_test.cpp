#include <catch2/catch.hpp>

#include "apps/pose_files.h"
#include "tests/collision/bodies.h"

using namespace ease;
using Catch::Contains;

namespace {

/// A ball of radius 0.3 m and beside it a small one, which goes from one side of it to the other.
SceneInput passing(double height) {
  const TriangleMesh large = bodies::sphere(0.3, 8), small = bodies::sphere(0.1, 6);
  const long n = large.positions.rows(), m = small.positions.rows();
  SceneInput input;
  input.body_triangles.resize(large.triangles.rows() + small.triangles.rows(), 3);
  input.body_triangles << large.triangles, small.triangles.array() + static_cast<int>(n);
  for (const double side : {-0.6, 0.6}) {
    Positions pose(n + m, 3);
    pose << large.positions, small.positions.rowwise() + Eigen::RowVector3d(side, height, 0.0);
    input.poses.push_back(pose);
    input.pose_names.push_back(side < 0.0 ? "before" : "behind");
  }
  input.way = std::make_shared<const InterpolatedPoses>(input.body_triangles, input.poses);
  return input;
}

std::vector<std::string> warningsOf(const SceneInput& input, int steps) {
  Scene scene;
  scene.file = "scene.toml";
  scene.body.emplace();
  scene.body->steps = steps;
  std::vector<std::string> warnings;
  checkMotion(scene, input, [&](const std::string& warning) { warnings.push_back(warning); });
  return warnings;
}

}  // namespace

TEST_CASE("a part of the body that would pass through another one is told before anything is computed") {
  const std::vector<std::string> warnings = warningsOf(passing(0.0), 60);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0],
             Contains("on the way from 'before' to 'behind' a part of the body passes through another one") &&
                 Contains("put a pose in between"));
  CHECK(warningsOf(passing(0.6), 60).empty());
}

TEST_CASE("a body whose surface is faster than people is told with its speed") {
  const std::vector<std::string> warnings = warningsOf(passing(0.6), 4);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Contains("the surface moves at 30 m/s from 'before' to 'behind': people reach 8 m/s"));
}
