#include "adaption/substeps.h"

#include <catch2/catch.hpp>
#include <tuple>

#include "solver/base/error.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

/// From the first pose to the second in 10 interpolation steps of 4 time steps each.
Schedule twoPoses() {
  Schedule schedule;
  schedule.poses = 2;
  schedule.interpolation_steps = 10;
  schedule.steps_per_pose = 4;
  return schedule;
}

/// Parts of the steps in which a body is lifted by `rise` (m) from its first pose to its second.
Substeps substepsOfRise(double rise, double offset) {
  return chooseSubsteps(twoPoses(), rise / 40.0, offset);
}

}  // namespace

TEST_CASE("a body's motion is that of its surface near the garment, in a time step") {
  const TriangleMesh sheet = makeSheet(4, 4, 0.2, 0.2);
  const Positions& garment = sheet.positions;
  std::vector<Positions> poses = {garment, garment};
  poses[1].col(1).array() += 0.4;
  CHECK(bodyMotionPerStep(twoPoses(), sheet.triangles, poses, garment) == Approx(0.01));
  poses[0].conservativeResize(poses[0].rows() + 1, 3);
  poses[1].conservativeResize(poses[1].rows() + 1, 3);
  poses[0].bottomRows(1) << 5.0, 0.0, 0.0;  // far away, and fast
  poses[1].bottomRows(1) << 5.0, 9.0, 0.0;
  CHECK(bodyMotionPerStep(twoPoses(), sheet.triangles, poses, garment) == Approx(0.01));
  poses[0] *= 100.0;  // triangles far larger than the garment, with corners far from it
  poses[1] = poses[0];
  poses[1].col(1).array() += 0.4;
  CHECK(bodyMotionPerStep(twoPoses(), sheet.triangles, poses, garment) == Approx(0.01));
  poses.pop_back();
  CHECK(bodyMotionPerStep(twoPoses(), sheet.triangles, poses, garment) == 0.0);
}

TEST_CASE("a time step is divided so that the body moves by the offset at most in a part") {
  for (const auto& [rise, offset, expected] : std::vector<std::tuple<double, double, int>>{
           {0.0, 0.005, 1}, {0.199, 0.005, 1}, {0.29, 0.005, 2}, {0.29, 0.02, 1}, {0.29, 0.0, 2}}) {
    CHECK(substepsOfRise(rise, offset).time == expected);
    CHECK(substepsOfRise(rise, offset).interpolation == 1);
  }
}

TEST_CASE("an interpolation step is divided so that a level set reaches to the next, with whole parts between") {
  const Substeps parts = substepsOfRise(0.7, 0.005);  // 7 cm an interpolation step of 4 time steps
  CHECK(parts.interpolation == 3);
  CHECK(parts.time == 6);  // 4 would do for contact
}

TEST_CASE("a body that jumps too far in a time step is refused") {
  CHECK_THROWS_AS(substepsOfRise(100.0, 0.005), InputError);
  CHECK_THROWS_WITH(substepsOfRise(100.0, 0.005), Catch::Contains("the body moves 2.5 m in a time step of 0.0025 s"));
}

TEST_CASE("a body that does not move divides nothing") {
  Schedule schedule = twoPoses();
  for (const int poses : {0, 1}) {
    schedule.poses = poses;
    CHECK(chooseSubsteps(schedule, 0.0, 0.005).time == 1);
  }
}
