// Time steps per second against the number of vertices, for a complete job with moving body, contact, adaption and
// output.
//
//   fps [--quick] [--data=DIR] [options of Google Benchmark]
//
// The scenes are scenes/t-shirt.toml with its garment remeshed, adapted on the way ("mannequin") and as the first pass
// of a fit, with that scene's own settings ("pass"), and the scans in DIR if there are any; every method has its
// default settings.  The time of a step includes everything except the setup (`setup_s`), the first step, which factors
// the system (`first_step_s`), and the replays; ms_step is the time of the simulation alone.  Large meshes take fewer
// steps (`steps`), and one run instead of three.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/program.h"
#include "bench/settings.h"
#include "bench/timed_job.h"
#include "solver/base/error.h"
#include "tests/places.h"

using namespace ease;

namespace {

constexpr int kRuns = 3, kLarge = 20000;  // kRuns runs below kLarge vertices, otherwise one
constexpr JobLimits kOfLarge{60, 1, 30.0};

/// Returns the scene with a built-in garment replaced by a mesh file, so that the garment is made only once for all
/// methods.
Scene withGarmentFile(Scene scene) {
  static const ScratchDirectory scratch;
  if (scene.garment.builtin.empty()) return scene;
  const auto file = scratch.path / fmt::format("{}_{}.obj", scene.garment.builtin, scene.garment.vertices);
  if (!std::filesystem::exists(file)) writeGarment(scene, file);
  scene.garment.mesh = file.string();
  scene.garment.builtin.clear();
  return scene;
}

void timeScene(benchmark::State& state, const Scene& given, const JobLimits& limits) try {
  const Scene scene = withGarmentFile(given);
  for (auto _ : state) {
    const JobTiming t = timeJob(scene, limits);
    if (t.failure[0]) {
      tellNoResult(state, t.failure);
      continue;
    }
    const double steps = t.steps, per_step = 1e3 / steps;
    state.SetIterationTime(t.run_s / steps);
    auto& counters = state.counters;
    counters["vertices"] = t.vertices;
    counters["steps"] = steps;
    counters["substeps"] = t.substeps;
    counters["fps_simulation"] = steps / t.times.step;
    counters["fps_full"] = steps / t.run_s;
    counters["ms_step"] = per_step * t.times.step;
    counters["ms_level_set"] = per_step * t.times.level_set;
    counters["ms_interpolation"] = per_step * t.times.interpolation;
    counters["ms_adaption"] = per_step * t.times.adaption;
    counters["ms_output"] = per_step * t.times.output;
    counters["setup_s"] = t.setup_s;
    counters["first_step_s"] = t.first_step_s;
    counters["peak_memory_MB"] = t.peak_memory_MB;
    counters["newton_iterations"] = t.newton_iterations / steps;
    counters["projective_iterations"] = t.projective_iterations / steps;
    counters["handed_over"] = t.handed_over / steps;
    counters["penetration_mm"] = t.penetration_mm;
  }
} catch (const ComputationError& error) {
  state.SkipWithError(error.what());
}

void registerScene(const std::string& body, Scene scene, const std::string& method, int vertices,
                   const JobLimits& limits) {
  scene.solver.method = methodNamed(method);
  const std::string name = fmt::format("fps/body:{}/n:{}/method:{}", body, vertices, method);
  benchmark::RegisterBenchmark(name.c_str(),
                               [scene, limits](benchmark::State& state) { timeScene(state, scene, limits); })
      ->Iterations(1)
      ->Repetitions(vertices < kLarge ? kRuns : 1)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

void registerAll(bool quick, const std::filesystem::path& data) {
  const std::filesystem::path source = kSourceDirectory;
  const JobLimits limits = quick ? JobLimits{20, 3, 3.0} : JobLimits{};
  std::vector<std::string> methods = allMethods();
  if (quick) methods = {"bw1", "auto"};
  std::vector<int> sizes = {1000, 2000, 4000, 10000, 30000, 100000};
  if (quick) sizes = {1000, 4000};
  Scene scene = readScene(source / "scenes" / "t-shirt.toml");
  Scene pass = scene;
  // A run that adapts on the way, with the cloth, the small steps and the fast motion that its figures have always had.
  scene.adaption->mode = AdaptionMode::sequential;
  scene.material.compression = Material().compression;
  scene.adaption->every = 8;
  scene.solver = SolverScene();
  scene.body->steps = 30;
  for (int n : sizes) {
    scene.garment.vertices = n;
    pass.garment.vertices = n;
    const JobLimits here = n < kLarge ? limits : kOfLarge;
    for (const std::string& method : methods) registerScene("mannequin", scene, method, n, here);
    for (const char* method : {"bw1", "auto"}) registerScene("pass", pass, method, n, here);
  }
  if (quick) return;
  if (!std::filesystem::exists(data / "avatars")) {
    fmt::print("no scans in {}: measuring on the mannequin alone\n", data.string());
    return;
  }
  for (int n : {1100, 3032, 4270, 10000})
    for (const std::string& method : methods)
      registerScene("scan", readScene(source / "tests" / "apps" / "scans" / fmt::format("shirt_{}.toml", n)), method, n,
                    limits);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string data = takeOption(argc, argv, "data", kSharedData);
  return runBenchmarks(argc, argv, "fps", [&](bool quick) { registerAll(quick, data); });
}
