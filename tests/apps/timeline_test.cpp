#include "apps/timeline.h"

#include <catch2/catch.hpp>
#include <tuple>

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
           {0.0, 0.005, 1}, {0.099, 0.005, 1}, {0.29, 0.005, 3}, {0.29, 0.02, 1}, {0.29, 0.0, 3}}) {
    const auto [scene, input] = lifted(rise, offset);
    CHECK(divisionFor(scene, input).time_steps == expected);
    CHECK(divisionFor(scene, input).interpolation_steps == 1);
  }
}

TEST_CASE("an interpolation step is divided so that a level set reaches to the next, with whole time steps between") {
  const auto [scene, input] = lifted(0.7, 0.005);  // 7 cm an interpolation step of 4 time steps
  const Division division = divisionFor(scene, input);
  CHECK(division.interpolation_steps == 3);
  CHECK(division.time_steps == 9);  // 7 would do for contact
  const Scene fine = divided(scene, division);
  CHECK(fine.body->steps == 30);
  CHECK(fine.solver.steps_per_pose == 12);
  CHECK(timeStepsOfMotion(fine) == 9 * timeStepsOfMotion(scene));
}

TEST_CASE("a body that jumps too far in a time step is refused") {
  const auto [scene, input] = lifted(100.0, 0.005);
  CHECK_THROWS_WITH(divisionFor(scene, input),
                    Catch::Contains("[body] steps = 10: the body moves 2.5 m in a time step of 0.0025 s"));
}

TEST_CASE("a body that does not move divides nothing") {
  auto [scene, input] = lifted(0.3, 0.005);
  input.poses.resize(1);
  CHECK(divisionFor(scene, input).time_steps == 1);
  input.poses.clear();
  CHECK(divisionFor(scene, input).time_steps == 1);
}

TEST_CASE("a divided scene has the same motion, and is adapted and written at the same times") {
  const auto [scene, input] = lifted(0.3, 0.005);
  const std::vector<Moment> whole = timeline(scene, true), parts = timeline(divided(scene, Division{3, 2}), true);
  REQUIRE(whole.size() == 40);
  REQUIRE(parts.size() == 120);
  for (size_t k = 0; k < whole.size(); ++k) {
    const Moment &a = whole[k], &b = parts[3 * k + 2];
    CHECK(b.time_s == Approx(a.time_s));
    CHECK(b.body == Approx(2.0 * a.body));
    CHECK(b.pose == a.pose);
    CHECK(b.adapts == a.adapts);
    CHECK(b.written == a.written);
    CHECK_FALSE(parts[3 * k].adapts);
  }
}

TEST_CASE("a run that goes on does what is left, and none of it is the motion that is done") {
  auto [scene, input] = lifted(0.0, 0.005);
  scene.adaption->settle = 6;
  const std::vector<Moment> whole = timeline(scene, true);
  REQUIRE(whole.size() == 46);
  CHECK(whole[39].pose == 1);
  CHECK_FALSE(whole[39].settles);
  CHECK(whole[40].settles);
  for (const size_t done : {7, 40, 43}) {
    const std::vector<Moment> left = timeline(scene, true, whole[done - 1].done);
    REQUIRE(left.size() == 46 - done);
    for (size_t k = 0; k < left.size(); ++k) {
      const Moment &a = left[k], &b = whole[done + k];
      CHECK(std::tie(a.time_s, a.body, a.next_level_set, a.pose, a.settles, a.adapts, a.written, a.measured) ==
            std::tie(b.time_s, b.body, b.next_level_set, b.pose, b.settles, b.adapts, b.written, b.measured));
    }
  }
  CHECK(timeline(scene, true, whole.back().done).empty());
}

TEST_CASE("a body that stood at its last pose goes on from there to one that was added, and stands there anew") {
  auto [scene, input] = lifted(0.0, 0.005);
  scene.adaption->settle = 6;
  const StepsDone done = timeline(scene, true).back().done;
  const auto goesOn = [&] {
    const std::vector<Moment> left = timeline(scene, true, done);
    REQUIRE(left.size() == 46);
    CHECK(left.front().done.all == 47);
    CHECK(left.front().body == Approx(10.25));
    CHECK(left[39].body == 20.0);
    CHECK(left.back().body == 20.0);
    return left[39].pose;
  };
  scene.body->poses.emplace_back("higher");
  CHECK(goesOn() == 2);
  scene.body->poses.pop_back();
  scene.adaption->cycles = 2;
  CHECK(goesOn() == 0);
  scene.adaption->cycles = 1;
  scene.adaption->settle = 8;
  CHECK(timeline(scene, true, done).size() == 2);
}

TEST_CASE("a body of one pose, or none, has no motion; steps are left until it was held long enough") {
  auto [scene, input] = lifted(0.0, 0.005);
  scene.body->poses.pop_back();
  CHECK(posesOfMotion(scene, true) == std::vector<int>{0});
  CHECK(timeline(scene, true).size() == 40);
  CHECK(timeline(scene, true, {13, 0, 13}).size() == 27);
  CHECK(timeline(scene, true, {13, 0, 13}).back().body == 0.0);
  scene.body.reset();
  scene.solver.steps = 30;
  CHECK(posesOfMotion(scene, true).empty());
  CHECK(timeline(scene, true, {13, 0, 13}).size() == 17);
}

TEST_CASE("poses come there and back again") {
  auto [scene, input] = lifted(0.0, 0.005);
  scene.body->poses = {"a", "b", "c"};
  scene.adaption->cycles = 3;
  CHECK(posesOfMotion(scene, true) == std::vector<int>{0, 1, 2, 1, 0, 1, 2});
  CHECK(posesOfMotion(scene, false) == std::vector<int>{0, 1, 2});
}
