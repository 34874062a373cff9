// The error of the rest shape against wall time: how far that of every pass of a fit (adaption/fit.h) is from a
// reference, over method, tolerance, time step and number of passes.
//
//   rest_shape [--quick] [--data=DIR] [options of Google Benchmark]
//
// The garment is the scanned woman's T-shirt of 1,100 vertices (`up`: T-pose to arms up; `a-up`: by way of the A-pose),
// without the scans in DIR the built-in one.  The reference is what the same passes let out in time steps of 0.0025 s
// and with a tolerance of 0.01.  A case `pass:k` is the rest shape that the first k passes let out:
//
//   real_time         s, of these passes
//   error             RMS over the edges of length / reference's length - 1
//   share_over_limit  of the triangles, at the worst moment of one replay that is the same for all, in time steps of
//                     0.005 s with a tolerance of 0.05
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>

#include "adaption/fit.h"
#include "apps/scene_run.h"
#include "bench/program.h"
#include "bench/settings.h"
#include "solver/base/stopwatch.h"
#include "tests/places.h"

using namespace ease;

namespace {

constexpr int kPasses = 8, kPassesQuick = 3;

/// How accurately the motion is computed.
struct Accuracy {
  std::string method;
  double tolerance;    // of auto and pd-lbfgs
  double time_step_s;  // the body moves on in every time step
};

const Accuracy kReference = {"auto", 0.01, 0.0025};
const Accuracy kReplay = {"auto", 0.05, 0.005};

std::string nameOf(const Accuracy& accuracy) {
  return fmt::format("method:{}/tolerance:{}/h:{}", accuracy.method, accuracy.tolerance, accuracy.time_step_s);
}

struct RestOfPass {
  std::vector<Mat2> edges;  // flat, m
  double wall_s;            // of all passes until then
};

/// A scene whose garment is fitted, or replayed, with different accuracies.
class Garment {
 public:
  Garment(std::string name, Scene scene, int passes)
      : name_(std::move(name)), scene_(std::move(scene)), passes_(passes), input_(readSceneInput(scene_)) {}

  const std::string& name() const { return name_; }
  int passes() const { return passes_; }
  int vertices() const { return static_cast<int>(input_.garment.positions.rows()); }

  /// The rest shape that each pass let out.  Computed once for each accuracy.
  const std::vector<RestOfPass>& fitted(const Accuracy& accuracy) {
    std::vector<RestOfPass>& passes = fits_[nameOf(accuracy)];
    if (passes.empty()) passes = fit(accuracy);
    return passes;
  }

  double error(const RestOfPass& rest) {
    Cloth cloth = clothWith(rest.edges), reference = clothWith(fitted(kReference).back().edges);
    double sum = 0.0;
    for (int t = 0; t < cloth.triangleCount(); ++t)
      for (int edge = 0; edge < 3; ++edge) sum += std::pow(length(cloth, t, edge) / length(reference, t, edge) - 1, 2);
    return std::sqrt(sum / (3.0 * cloth.triangleCount()));
  }

  /// Share of the triangles over the limit in the replay.
  double shareOverLimit(const RestOfPass& rest) {
    Cloth cloth = clothWith(rest.edges);
    const Scene scene = with(kReplay);
    MovingBody body = movingBody(scene, input_);
    const RunInput run_input = runInput(scene, input_, &body);
    Run run(runSettings(scene, replaySchedule(scene)), run_input, cloth);
    run.run();
    return run.record().stretch.overall.share_over_limit;
  }

 private:
  static double length(const Cloth& cloth, int t, int edge) {
    const Mat2& edges = cloth.restEdges()[t];
    return edge == 2 ? (edges.col(1) - edges.col(0)).norm() : edges.col(edge).norm();
  }

  Cloth clothWith(const std::vector<Mat2>& edges) const {
    Cloth cloth(input_.garment, scene_.garment.grain, scene_.material);
    cloth.setRest({cloth.restPositions(), edges});
    return cloth;
  }

  Scene with(const Accuracy& accuracy) const {
    Scene scene = scene_;
    scene.solver.method = methodNamed(accuracy.method);
    scene.solver.tolerance = accuracy.tolerance;
    scene.solver.time_step = accuracy.time_step_s;
    scene.solver.steps_per_pose = 1;
    scene.body->steps = static_cast<int>(std::lround(scene.body->seconds_per_pose / accuracy.time_step_s));
    scene.adaption->every = std::max(1, static_cast<int>(std::lround(0.02 / accuracy.time_step_s)));
    scene.adaption->fit = {0.0, passes_};
    return scene;
  }

  std::vector<RestOfPass> fit(const Accuracy& accuracy) {
    const Scene scene = with(accuracy);
    MovingBody body = movingBody(scene, input_);
    const RunInput run_input = runInput(scene, input_, &body);
    Cloth cloth(input_.garment, scene.garment.grain, scene.material);
    Fit fit(runSettings(scene, replaySchedule(scene)), scene.adaption->fit, run_input, cloth);
    std::vector<RestOfPass> passes;
    std::atomic<bool> enough = false;
    FitWatch watch;
    watch.interrupted = &enough;
    const auto start = std::chrono::steady_clock::now();
    watch.on_pass = [&](const FitState& state) {
      passes.push_back({state.next_rest, secondsSince(start)});
      enough = static_cast<int>(passes.size()) == passes_ || state.over;  // no embedding, no check
    };
    fit.run(watch);
    return passes;
  }

  const std::string name_;
  const Scene scene_;
  const int passes_;
  const SceneInput input_;
  std::map<std::string, std::vector<RestOfPass>> fits_;
};

void registerFit(const std::shared_ptr<Garment>& garment, const Accuracy& accuracy) {
  for (int pass = 1; pass <= garment->passes(); ++pass) {
    const std::string name = fmt::format("rest_shape/garment:{}/n:{}/{}/pass:{}", garment->name(), garment->vertices(),
                                         nameOf(accuracy), pass);
    benchmark::RegisterBenchmark(name.c_str(),
                                 [garment, accuracy, pass](benchmark::State& state) {
                                   for (auto _ : state) {
                                     const std::vector<RestOfPass>& passes = garment->fitted(accuracy);
                                     if (pass > std::ssize(passes)) {
                                       tellNoResult(state, "the fit ended before this pass");
                                       continue;
                                     }
                                     const RestOfPass& rest = passes[pass - 1];
                                     state.SetIterationTime(rest.wall_s);
                                     state.counters["error"] = garment->error(rest);
                                     state.counters["share_over_limit"] = garment->shareOverLimit(rest);
                                   }
                                 })
        ->Iterations(1)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

Scene onScans(const std::filesystem::path& file, bool by_way_of_a) {
  Scene scene = readScene(file);
  if (!by_way_of_a) scene.body->poses.erase(scene.body->poses.begin() + 1);
  return scene;
}

void registerAll(bool quick, const std::filesystem::path& data) {
  const std::filesystem::path source = kSourceDirectory;
  const int passes = quick ? kPassesQuick : kPasses;
  std::vector<std::shared_ptr<Garment>> garments;
  if (std::filesystem::exists(data / "avatars")) {
    const auto file = source / "tests" / "apps" / "scans" / "fit_1100.toml";
    garments.push_back(std::make_shared<Garment>("up", onScans(file, false), passes));
    if (!quick) garments.push_back(std::make_shared<Garment>("a-up", onScans(file, true), passes));
  } else {
    fmt::print("no scans in {}: measuring on the mannequin alone\n", data.string());
    Scene scene = readScene(source / "scenes" / "t-shirt.toml");
    scene.garment.vertices = 1000;
    garments.push_back(std::make_shared<Garment>("mannequin", scene, passes));
  }
  std::vector<Accuracy> accuracies = {kReference};
  for (const double h : {0.0025, 0.005, 0.0125, 0.025}) accuracies.push_back({"auto", 0.2, h});
  if (!quick) {
    for (const double tolerance : {0.05, 0.4}) accuracies.push_back({"auto", tolerance, 0.0125});
    accuracies.push_back({"auto", 0.05, 0.0025});
    for (const std::string method : {"bw1", "pd", "pd-lbfgs", "newton"}) accuracies.push_back({method, 0.2, 0.0125});
  }
  for (const auto& garment : garments)
    for (const Accuracy& accuracy : accuracies) registerFit(garment, accuracy);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string data = takeOption(argc, argv, "data", kSharedData);
  return runBenchmarks(argc, argv, "rest_shape", [&](bool quick) { registerAll(quick, data); });
}
