// Seams that the program finds: metres to sew and pieces against how far threads stretch, over the weights of
// distortion and length, before and after needless seams are removed and the others straightened.
//
//   cuts [--quick] [--data=DIR] [options of Google Benchmark]
//
// The garments are T-shirts of 1,100 and 4,271 vertices on a scanned woman, without the scans in DIR the built-in one,
// each as its own rest shape.  The time is that of the search.
//
//   pieces, seams_m       seams and openings, without darts, which are not looked for here
//   thread_mean, _p99     stretch of the threads, flattened as in a pattern
//   rigid_mean, _p99      the larger principal stretch, flattened as rigidly as may be: the measure of codes that know
//                         no threads
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <tuple>

#include "apps/flat_settings.h"
#include "bench/program.h"
#include "garment/builtin_garment.h"
#include "garment/pattern/variational_cut.h"
#include "solver/io/mesh_io.h"
#include "solver/model/cloth.h"
#include "tests/places.h"

using namespace ease;

namespace {

struct Shirt {
  std::string name;
  RestGarment garment;
};

Shirt shirtOf(const std::string& name, const TriangleMesh& mesh) {
  const Scene scene;
  const Cloth cloth(mesh, scene.garment.grain, scene.material);
  return {name, {{cloth.restPositions(), mesh.triangles}, cloth.restEdges(), {}, {}}};
}

/// Mean, and what 99 % of the area lie below.
std::pair<double, double> meanAndP99(std::vector<std::pair<double, double>> value_and_area) {
  std::sort(value_and_area.begin(), value_and_area.end());
  double area = 0.0, sum = 0.0, reached = 0.0;
  for (const auto& [value, a] : value_and_area) {
    area += a;
    sum += a * value;
  }
  for (const auto& [value, a] : value_and_area)
    if ((reached += a) >= 0.99 * area) return {sum / area, value};
  return {0.0, 0.0};
}

/// The larger of a triangle's principal stretches on the paper, from 1.
double principalStretch(const FlatPattern& pattern, const Positions& x, int t) {
  const Mat2 edges = edgeMatrix(x, pattern.flat.triangles, t).topRows<2>();
  const Eigen::JacobiSVD<Mat2> svd(pattern.flat.rest_edges[t] * edges.inverse());
  return std::max(std::abs(svd.singularValues()[0] - 1.0), std::abs(svd.singularValues()[1] - 1.0));
}

void measure(const FoundCuts& found, const FlatSettings& settings, benchmark::State& state) {
  const FlatPattern pattern = flattenGarment(found.cut.garment, settings);
  WovenSettings rigid;
  rigid.shear = 1.0;
  rigid.seam_weight = 0.0;
  const Positions x = flatten(pattern.flat, {}, rigid, &pattern.x).x;
  std::vector<std::pair<double, double>> threads, principal;
  for (size_t t = 0; t < pattern.strains.size(); ++t) {
    const double area = 0.5 * pattern.flat.rest_edges[t].determinant();
    threads.emplace_back(pattern.strains[t].worst(), area);
    principal.emplace_back(principalStretch(pattern, x, static_cast<int>(t)), area);
  }
  double length = 0.0;
  for (const SeamSides& seam : pattern.seams) length += seam.rest_length;
  state.counters["pieces"] = static_cast<double>(pattern.pieces.size());
  state.counters["seams_m"] = length;
  std::tie(state.counters["thread_mean"].value, state.counters["thread_p99"].value) = meanAndP99(threads);
  std::tie(state.counters["rigid_mean"].value, state.counters["rigid_p99"].value) = meanAndP99(principal);
}

void registerCuts(const std::shared_ptr<Shirt>& shirt, double distortion, bool is_symmetric) {
  for (const bool is_after : {false, true}) {
    const std::string name = fmt::format("cuts/garment:{}/symmetric:{}/distortion:{}/stage:{}", shirt->name,
                                         is_symmetric ? "yes" : "no", distortion, is_after ? "after" : "before");
    benchmark::RegisterBenchmark(name.c_str(),
                                 [shirt, distortion, is_symmetric, is_after](benchmark::State& state) {
                                   FlatSettings settings = flatSettings(Scene());
                                   settings.max_darts = 0;
                                   CutSettings cuts;
                                   cuts.flow.weights.distortion = distortion;
                                   cuts.is_symmetric = is_symmetric;
                                   cuts.remove = cuts.straighten = is_after;
                                   for (auto _ : state) {
                                     const FoundCuts found = findCuts(shirt->garment, cuts, settings);
                                     state.SetIterationTime(found.wall_s);
                                     measure(found, settings, state);
                                   }
                                 })
        ->Iterations(1)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

void registerAll(bool quick, const std::filesystem::path& data) {
  std::vector<std::shared_ptr<Shirt>> shirts;
  for (const char* vertices : {"1100", "4270"}) {
    const std::filesystem::path file = data / "garments" / fmt::format("shirt_{}.obj", vertices);
    if (!std::filesystem::exists(file) || (quick && !shirts.empty())) continue;
    shirts.push_back(std::make_shared<Shirt>(shirtOf(file.stem().string(), readMesh(file))));
  }
  if (shirts.empty()) {
    fmt::print("no garments in {}: measuring on the built-in T-shirt alone\n", data.string());
    shirts.push_back(std::make_shared<Shirt>(shirtOf("built-in", builtinGarment("t-shirt", 1000, 0.004))));
  }
  const std::vector<double> weights = quick ? std::vector<double>{3, 10, 30} : std::vector<double>{1, 3, 10, 30, 100};
  for (const auto& shirt : shirts)
    for (const bool is_symmetric : {false, true})
      for (const double weight : weights) registerCuts(shirt, weight, is_symmetric);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string data = takeOption(argc, argv, "data", kSharedData);
  return runBenchmarks(argc, argv, "cuts", [&](bool quick) { registerAll(quick, data); });
}
