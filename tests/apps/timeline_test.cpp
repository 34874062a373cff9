#include "apps/timeline.h"

#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

namespace {

// A body that is lifted by `rise` (m) from its first pose to its second, in 10 interpolation steps.
std::pair<Scene, SceneInput> lifted(double rise, double offset) {
  Scene scene;
  scene.body.emplace();
  scene.body->steps = 10;
  scene.body->poses = {"low", "high"};
  scene.solver.steps_per_pose = 4;
  scene.collision.offset = offset;
  scene.adaption.emplace();
  scene.output.emplace();
  SceneInput input;
  input.garment = makeSheet(4, 4, 0.2, 0.2);
  input.poses = {input.garment.positions, input.garment.positions};
  input.poses[1].col(1).array() += rise;
  return {scene, input};
}

}  // namespace

TEST_CASE("a time step is divided so that the body moves by half the offset at most in a part") {
  for (const auto& [rise, offset, expected] : std::vector<std::tuple<double, double, int>>{
           {0.0, 0.005, 1}, {0.099, 0.005, 1}, {0.29, 0.005, 3}, {0.29, 0.02, 1}, {0.29, 0.0, 3}, {100.0, 0.005, 64}}) {
    const auto [scene, input] = lifted(rise, offset);
    CHECK(substepsFor(scene, input) == expected);
  }
}

TEST_CASE("a body that does not move divides nothing") {
  auto [scene, input] = lifted(0.3, 0.005);
  input.poses.resize(1);
  CHECK(substepsFor(scene, input) == 1);
  input.poses.clear();
  CHECK(substepsFor(scene, input) == 1);
}

TEST_CASE("a divided scene has the same motion, and is adapted and written at the same times") {
  const auto [scene, input] = lifted(0.3, 0.005);
  const std::vector<Moment> whole = timeline(scene, true), parts = timeline(divided(scene, 3), true);
  REQUIRE(whole.size() == 40);
  REQUIRE(parts.size() == 120);
  for (size_t k = 0; k < whole.size(); ++k) {
    const Moment &a = whole[k], &b = parts[3 * k + 2];
    CHECK(b.time_s == Approx(a.time_s));
    CHECK(b.body == Approx(a.body));
    CHECK(b.pose == a.pose);
    CHECK(b.adapts == a.adapts);
    CHECK(b.written == a.written);
    CHECK_FALSE(parts[3 * k].adapts);
  }
}
