#include "adaption/run.h"

#include <catch2/catch.hpp>

#include "tests/collision/bodies.h"
#include "tests/sheet.h"

using namespace ease;

TEST_CASE("the contact pressure of cloth at rest on a body sums to its weight, and far cloth knows its gap") {
  const TriangleMesh block = bodies::box(Vec3(-0.5, -0.5, -0.5), Vec3(0.5, 0.0, 0.5));
  MovingBody body(block.triangles, {block.positions}, 10, LevelSetOptions{0.01, 0.03});
  TriangleMesh sheet = makeSheet(8, 8, 0.2, 0.2, 0.2);
  sheet.positions.col(2) = -sheet.positions.col(1);
  sheet.positions.col(1).setConstant(0.005);
  Material material;
  material.density = 0.3;
  Cloth cloth(sheet, Vec3(1, 0, 0), material);
  RunSettings settings;
  settings.schedule.poses = 1;
  settings.schedule.interpolation_steps = 100;
  settings.schedule.steps_per_pose = 2;
  settings.schedule.write_every = 200;
  RunInput input{sheet.positions, std::vector<double>(cloth.vertexCount(), 0.005), {}, &body, 0.0};
  double force = 0.0;
  RunWatch watch;
  watch.on_frame = [&](const Snapshot& shot) {
    force = 0.0;
    for (int t = 0; t < cloth.triangleCount(); ++t)
      for (int k = 0; k < 3; ++k)
        force +=
            shot.pressure[cloth.triangles()(t, k)] * triangleArea(shot.state.positions, cloth.triangles(), t) / 3.0;
  };
  Run(settings, input, cloth).run(watch);
  CHECK(force == Approx(0.3 * 0.2 * 0.2 * 9.81).epsilon(0.02));

  settings.schedule.interpolation_steps = 1;
  settings.schedule.write_every = 2;
  input.start.col(1).setConstant(0.8);
  double gap = 0.0;
  watch.on_frame = [&](const Snapshot& shot) { gap = shot.gap[0]; };
  Run falling(settings, input, cloth);
  falling.run(watch);
  CHECK(gap == Approx(0.795).margin(1e-3));
  CHECK(falling.record().on_body.at(0).off_since_s == 0.0);
}
