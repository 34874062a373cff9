#include "apps/scene_run.h"

#include <catch2/catch.hpp>

#include "solver/base/error.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

/// Makes a scene whose body is lifted by `rise` (m) from its first pose to its second.
std::pair<Scene, SceneInput> lifted(double rise) {
  Scene scene;
  scene.file = "lifted.toml";
  scene.body.emplace();
  scene.body->steps = 10;
  scene.body->poses = {"low", "high"};
  scene.adaption.emplace();
  scene.adaption->cycles = 3;
  scene.adaption->settle = 5;
  scene.output.emplace();
  SceneInput input;
  input.garment = makeSheet(4, 4, 0.2, 0.2);
  input.body_triangles = input.garment.triangles;
  input.poses = {input.garment.positions, input.garment.positions};
  input.poses[1].col(1).array() += rise;
  return {scene, input};
}

}  // namespace

TEST_CASE("a replay goes once through the motion of the run that adapts, without adapting or writing") {
  const auto [scene, input] = lifted(0.1);
  const Schedule adapting = adaptingSchedule(scene), replay = replaySchedule(scene);
  CHECK(timeline(adapting).size() == 3 * timeline(replay).size() + 5);
  CHECK(timeStepsOfMotion(adapting) == timeStepsOfMotion(replay));
  for (const Moment& m : timeline(replay)) CHECK_FALSE((m.adapts || m.written));
}

TEST_CASE("a body that is too fast is refused with the scene's file and key") {
  const auto [scene, input] = lifted(100.0);
  CHECK_THROWS_AS(substepsOf(scene, input), InputError);
  CHECK_THROWS_WITH(substepsOf(scene, input),
                    Catch::Contains("lifted.toml: [body] steps = 10: the body moves 2.5 m in a time step of 0.0025 s"));
}

TEST_CASE("pins of a scene reach the run with what they are tied to") {
  auto [scene, input] = lifted(0.1);
  input.pins = {{0, 4}, {7}};
  scene.garment.pins.resize(2);
  scene.garment.pins[1].to_body = false;
  const RunInput run = runInput(scene, input, nullptr);
  REQUIRE(run.pins.size() == 2);
  CHECK(run.pins[0].vertices == std::vector<int>{0, 4});
  CHECK(run.pins[0].to_body);
  CHECK_FALSE(run.pins[1].to_body);
}
