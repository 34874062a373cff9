// Maps of where each method, with its default settings, fails to keep cloth outside a body that moves.
//
//   contact_stability [--quick] [options of Google Benchmark]
//
// A plate comes from behind a free sheet of 121 vertices (0.3 m wide, no gravity) and pushes it 0.25 m ahead, through
// the whole run: interpolated poses, level sets of 10 mm voxels, contacts, steps.  One map varies the time step and the
// plate's speed (20 mm thick), the other the time step and the plate's thickness (at 1 m/s).  Counters:
//
//   depth_mm       deepest point of the cloth in the plate
//   speed_ratio    speed of the fastest vertex at the end, over the plate's
//   grade          2 converged: at most 0.1 mm deep, no vertex faster than 3 times the plate
//                  1 degraded
//                  0 failed: cloth behind the plate's front by more than 0.1 mm at the end, a position that is not
//                    finite, or a run that could not be completed
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/scene_run.h"
#include "bench/program.h"
#include "bench/settings.h"
#include "solver/base/error.h"
#include "tests/collision/bodies.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

constexpr double kTravel = 0.25, kWidth = 0.3;  // m
constexpr int kSide = 10;                       // of the sheet, cells
constexpr double kTouch = 1e-4;                 // m: depth that contact may have
constexpr double kThrown = 3.0;                 // times the plate's speed

struct Push {
  double h, speed, thickness;  // s, m/s, m
  std::string method;
};

enum Grade { kFailed = 0, kDegraded = 1, kGood = 2 };

void push(benchmark::State& state, const Push& given) {
  Scene scene;
  scene.solver.method = methodNamed(given.method);
  scene.solver.gravity.setZero();
  scene.solver.time_step = given.h;
  scene.solver.steps_per_pose = 1;
  scene.body.emplace();
  scene.body->poses = {"behind", "ahead"};
  scene.body->steps = std::max(1, static_cast<int>(std::lround(kTravel / (given.speed * given.h))));
  scene.material.bending = 1e-6;

  SceneInput input;
  input.garment = makeSheet(kSide, kSide, kWidth, kWidth);
  input.garment.positions.leftCols(2).array() -= 0.5 * kWidth;
  const double front = -scene.collision.offset - kTouch;  // of the plate at the start
  const TriangleMesh plate = bodies::box(Vec3(-kWidth, -kWidth, front - given.thickness), Vec3(kWidth, kWidth, front));
  input.body_triangles = plate.triangles;
  input.poses = {plate.positions, bodies::moved(plate, Vec3(0.0, 0.0, kTravel)).positions};
  input.offsets.assign(input.garment.positions.rows(), scene.collision.offset);

  for (auto _ : state) {
    Cloth cloth(input.garment, scene.garment.grain, scene.material);
    MovingBody body = movingBody(scene, input);
    const RunInput run_input = runInput(scene, input, &body);
    Run run(runSettings(scene, replaySchedule(scene)), run_input, cloth);
    bool completed = true;
    try {
      run.run();
    } catch (const ComputationError&) {
      completed = false;
    }
    const PassRecord& record = run.record();
    state.SetIterationTime(record.times.total / std::max(1, record.steps));
    const State& end = run.state();
    const bool ahead =
        completed && end.positions.allFinite() && end.positions.col(2).minCoeff() >= front + kTravel - kTouch;
    const double depth =
        std::max({record.penetration.vertices, record.penetration.edge_midpoints, record.penetration.centroids});
    const double speed_ratio = end.velocities.rowwise().norm().maxCoeff() / given.speed;
    state.counters["grade"] = !ahead ? kFailed : depth <= kTouch && speed_ratio <= kThrown ? kGood : kDegraded;
    if (!completed) continue;
    state.counters["depth_mm"] = 1e3 * depth;
    state.counters["speed_ratio"] = speed_ratio;
  }
}

void registerPush(const std::string& map, const Push& given) {
  const std::string name = fmt::format("contact/map:{}/speed:{:.4g}/thickness:{:.4g}/h:{:.4g}/method:{}", map,
                                       given.speed, given.thickness, given.h, given.method);
  benchmark::RegisterBenchmark(name.c_str(), [given](benchmark::State& state) { push(state, given); })
      ->Iterations(1)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

void registerAll(bool quick) {
  std::vector<double> rates = {960, 480, 240, 120, 60, 30}, speeds = {0.1, 0.3, 1, 3, 10};
  std::vector<double> thicknesses = {0.0005, 0.002, 0.005, 0.01, 0.02, 0.05};
  if (quick) rates = {480, 30}, speeds = {0.3, 10}, thicknesses = {0.002, 0.05};
  for (const std::string& method : allMethods())
    for (const double rate : rates) {
      for (const double speed : speeds) registerPush("speed", {1.0 / rate, speed, 0.02, method});
      for (const double thickness : thicknesses) registerPush("thickness", {1.0 / rate, 1.0, thickness, method});
    }
}

}  // namespace

int main(int argc, char** argv) {
  return runBenchmarks(argc, argv, "contact_stability", registerAll);
}
