// The level set of a pose: time to build it, time per sample, memory, and error compared with exact distances.
//
//   level_set_bench [--data=DIR] [--voxel=METRES] [options of Google Benchmark]
//
// The bodies are the scans in DIR or, if there are none, a capsule.  The exit code is 1 if an error exceeds its bound.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <string>

#include "bench/program.h"
#include "collision/level_set.h"
#include "solver/io/mesh_io.h"
#include "solver/mesh/topology.h"
#include "solver/model/samples.h"
#include "tests/collision/bodies.h"
#include "tests/places.h"

namespace {

using namespace ease;

constexpr double kWithin = 0.005;        // m: errors are measured up to this distance
constexpr double kMarginInVoxels = 0.3;  // distance that samples may move until the next pose
constexpr double kSway = 0.004;          // m: motion of the body from one pose to the next

struct Subject {
  std::string name;
  TriangleMesh body;
  std::vector<Vec3> samples;  // contact samples of a garment
};

/// Errors of the level set's distances, mm; `wrong_signs` is the share of points on the wrong side.
struct Errors {
  double median, p95, max, wrong_signs;
};

/// Largest allowed errors at a voxel of 1 cm: about twice the errors of the scans.
constexpr Errors kBound = {0.06, 0.3, 2.5, 0.01};

/// Returns the positions of the garment's contact samples.
std::vector<Vec3> samplesOf(const TriangleMesh& garment, const std::string& name) {
  std::vector<Vec3> samples;
  const Topology topology = buildTopology(garment, name);
  ContactSamples(static_cast<int>(garment.positions.rows()), topology.edges, garment.triangles)
      .positions(garment.positions, samples);
  return samples;
}

std::vector<Subject> scans(const std::filesystem::path& data) {
  std::vector<Subject> subjects;
  const TriangleMesh body = readMesh(data / "avatars" / "slim_t_pose.ply");
  for (const char* garment : {"shirt_4270", "shirt_10000"}) {
    const std::filesystem::path file = data / "garments" / (std::string(garment) + ".obj");
    subjects.push_back({fmt::format("slim_t_pose/{}", garment), body, samplesOf(readMesh(file), file.string())});
  }
  return subjects;
}

/// Makes a limb and a sleeve 5 mm away from it, with about as many triangles and samples as a scan and a shirt.
std::vector<Subject> capsules() {
  const double half_length = 0.4, radius = 0.15;
  TriangleMesh sleeve = bodies::capsule(half_length, radius + 0.005, 18);
  return {{"capsule/sleeve", bodies::capsule(half_length, radius, 48), samplesOf(sleeve, "sleeve")}};
}

/// Returns points within 5 mm of the surface, each on the normal at the surface point closest to a sample.
std::vector<Vec3> pointsNearSurface(const TriangleTree& tree, const std::vector<Vec3>& samples) {
  std::vector<Vec3> points;
  for (size_t i = 0; i < samples.size(); ++i) {
    const ClosestPoint on_surface = tree.closest(samples[i], 0.05);
    if (on_surface.triangle < 0) continue;
    const double share = std::fmod(0.5 + static_cast<double>(i) * 0.6180339887498949, 1.0);
    points.push_back(on_surface.point + (2.0 * share - 1.0) * kWithin * on_surface.pseudonormal.normalized());
  }
  return points;
}

/// Measures the errors of the level set at the points.  Exact distances get their sign from the winding number, those
/// of the level set from pseudonormals.
Errors measureErrors(const TriangleTree& tree, LevelSet& level_set, const std::vector<Vec3>& points, double voxel) {
  level_set.build(tree, points, kMarginInVoxels * voxel);
  std::vector<LevelSetSample> samples(points.size());
  level_set.sample(points, samples);
  std::vector<double> errors;
  double wrong = 0.0;
  for (size_t i = 0; i < points.size(); ++i) {
    const double exact = tree.signedDistance(points[i], 0.03);
    if (std::abs(exact) > kWithin) continue;
    errors.push_back(1e3 * std::abs(samples[i].phi - exact));
    wrong += (samples[i].phi < 0.0) != (exact < 0.0) ? 1.0 : 0.0;
  }
  std::sort(errors.begin(), errors.end());
  const size_t n = errors.size();
  return {errors[n / 2], errors[n * 95 / 100], errors.back(), wrong / static_cast<double>(n)};
}

void preparePose(benchmark::State& state, const Subject& subject, double voxel) {
  TriangleTree tree(subject.body.positions, subject.body.triangles);
  const Positions poses[2] = {subject.body.positions, bodies::moved(subject.body, Vec3(0.0, 0.0, kSway)).positions};
  LevelSet level_set({.voxel = voxel, .band = 0.03});
  int pose = 0;
  for (auto _ : state) {
    tree.refit(poses[++pose & 1]);
    level_set.build(tree, subject.samples, kMarginInVoxels * voxel);
  }
  state.counters["samples"] = static_cast<double>(subject.samples.size());
  state.counters["voxels"] = static_cast<double>(level_set.filledVoxels());
  state.counters["MB"] = 1e-6 * static_cast<double>(level_set.memoryBytes());
}

void sampleAll(benchmark::State& state, const Subject& subject, double voxel) {
  const TriangleTree tree(subject.body.positions, subject.body.triangles);
  LevelSet level_set({.voxel = voxel, .band = 0.03});
  level_set.build(tree, subject.samples, kMarginInVoxels * voxel);
  std::vector<LevelSetSample> samples(subject.samples.size());
  for (auto _ : state) level_set.sample(subject.samples, samples);
  state.counters["per_sample"] = benchmark::Counter(
      static_cast<double>(samples.size()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Prints the errors; returns false if one exceeds its bound, which is kBound at 1 cm and grows with the voxel.
bool checkErrors(const Subject& subject, double voxel) {
  const TriangleTree tree(subject.body.positions, subject.body.triangles);
  LevelSet level_set({.voxel = voxel, .band = 0.03});
  const std::vector<Vec3> points = pointsNearSurface(tree, subject.samples);
  const Errors e = measureErrors(tree, level_set, points, voxel);
  const double scale = std::max(1.0, voxel / 0.01);
  const bool good = e.median <= kBound.median * scale && e.p95 <= kBound.p95 * scale && e.max <= kBound.max * scale &&
                    e.wrong_signs <= kBound.wrong_signs * scale;
  fmt::print(
      "{}, voxel {} mm, {} points within {} mm: error median {:.3f}, p95 {:.3f}, max {:.3f} mm; "
      "{:.2f} % wrong signs: {}\n",
      subject.name, 1e3 * voxel, points.size(), 1e3 * kWithin, e.median, e.p95, e.max, 100.0 * e.wrong_signs,
      good ? "within bounds" : "OUT OF BOUNDS");
  return good;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::filesystem::path data = takeOption(argc, argv, "data", kSharedData);
  const double voxel = std::stod(takeOption(argc, argv, "voxel", "0.01"));
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  const bool has_scans = std::filesystem::exists(data / "avatars" / "slim_t_pose.ply");
  if (!has_scans) fmt::print("no scans in {}: measuring on a capsule\n", data.string());

  const std::vector<Subject> subjects = has_scans ? scans(data) : capsules();
  bool good = true;
  for (const Subject& subject : subjects) {
    good = checkErrors(subject, voxel) && good;
    benchmark::RegisterBenchmark(("pose/" + subject.name).c_str(),
                                 [&](benchmark::State& state) { preparePose(state, subject, voxel); })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->MeasureProcessCPUTime();
    benchmark::RegisterBenchmark(("sample/" + subject.name).c_str(),
                                 [&](benchmark::State& state) { sampleAll(state, subject, voxel); })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->MeasureProcessCPUTime();
  }
  benchmark::RunSpecifiedBenchmarks();
  return good ? 0 : 1;
} catch (const std::exception& error) {
  fmt::print(stderr, "level_set_bench: {}\n", error.what());
  return 1;
}
