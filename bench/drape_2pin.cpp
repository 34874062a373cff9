// The scene drape-2pin, for which results of other codes are known: compares the rest state with theirs, and measures
// time and error of a step of 1/60 s for every method.
//
//   drape_2pin [--quick] [options of Google Benchmark]
//
//   mean_sigma_1   larger principal stretch, mean over rest area, dimensionless
//   centre_sag_m   distance of the middle below the two corners, m
//
// 120 steps without damping are timed.  In 480 more steps the velocities are multiplied by 0.95 after each step, so
// that the sheet comes to rest.  Four independent implicit codes agree about the rest state (kConsensus); the counter
// `agrees` shows whether a method agrees with them.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <chrono>

#include "adaption/stretch_measure.h"
#include "bench/program.h"
#include "bench/step_curve.h"
#include "solver/base/error.h"
#include "solver/base/stopwatch.h"

using namespace ease;

namespace {

constexpr double kStiffness = 1000.0;  // N/m
constexpr double kStep = 1.0 / 60.0;   // s
constexpr int kSwing = 120, kSettle = 480;

struct Rest {
  int side;
  double sigma_low, sigma_high, sag_low, sag_high;
};
constexpr Rest kConsensus[] = {{32, 1.00159, 1.00165, 0.5209, 0.5213},
                               {64, 1.00165, 1.00169, 0.5135, 0.5139},
                               {100, 1.00165, 1.00165, 0.5114, 0.5114}};
constexpr double kSigmaSlack = 5e-5;  // tolerance beyond the range of the codes
constexpr double kSagSlack = 1e-3;    // m

double meanStretch(const Cloth& cloth, const Positions& x) {
  std::vector<Stretch> stretch;
  measureStretch(cloth, x, stretch);
  double sum = 0.0, area = 0.0;
  for (int t = 0; t < cloth.triangleCount(); ++t) {
    sum += cloth.restAreas()[t] * stretch[t].sigma_1;
    area += cloth.restAreas()[t];
  }
  return sum / area;
}

/// Returns the sag of vertex (N/2, N/2), m.  The number of vertices along an edge, N, is even, so that this vertex lies
/// half a cell beyond the middle; the other codes also measure the sag there.
double centreSag(const Positions& x, int side) {
  return -x(side / 2 * side + side / 2, 1);
}

void fallAndRest(benchmark::State& state, const Rest& expected, const Setting& setting) try {
  const auto sheet = makeDrape2Pin(expected.side, kStiffness);
  for (auto _ : state) {
    TimeStep step(sheet->cloth, setting.options, sheet->ordering);
    State cloth = sheet->start;
    const auto start = std::chrono::steady_clock::now();
    for (int n = 0; n < kSwing; ++n) advance(*sheet, step, n * kStep, kStep, cloth);
    state.SetIterationTime(secondsSince(start) / kSwing);
    for (int n = kSwing; n < kSwing + kSettle; ++n) {
      advance(*sheet, step, n * kStep, kStep, cloth);
      cloth.velocities *= 0.95;
    }
    const double sigma = meanStretch(sheet->cloth, cloth.positions), sag = centreSag(cloth.positions, expected.side);
    state.counters["mean_sigma_1"] = sigma;
    state.counters["centre_sag_m"] = sag;
    const bool agrees = sigma >= expected.sigma_low - kSigmaSlack && sigma <= expected.sigma_high + kSigmaSlack &&
                        sag >= expected.sag_low - kSagSlack && sag <= expected.sag_high + kSagSlack;
    state.counters["agrees"] = agrees ? 1.0 : 0.0;
    state.counters["others_sigma_1_low"] = expected.sigma_low;
    state.counters["others_sigma_1_high"] = expected.sigma_high;
    state.counters["others_sag_low_m"] = expected.sag_low;
    state.counters["others_sag_high_m"] = expected.sag_high;
  }
} catch (const ComputationError& error) {
  state.SkipWithError(error.what());
}

void registerRest(const Rest& expected, const Setting& setting) {
  const std::string name =
      fmt::format("rest/sheet:drape-2pin/n:{}/k:{:g}/h:{:.4g}/method:{}/{}:{:g}", expected.side * expected.side,
                  kStiffness, kStep, setting.method, setting.knob, setting.value);
  benchmark::RegisterBenchmark(name.c_str(),
                               [expected, setting](benchmark::State& state) { fallAndRest(state, expected, setting); })
      ->Iterations(1)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

void registerAll(bool quick) {
  for (const Rest& expected : kConsensus) {
    if (quick && expected.side > 32) continue;
    for (const std::string& method : allMethods())
      if (method == "auto" || (expected.side == 32 && !quick)) registerRest(expected, defaultSettingOf(method));
  }
  for (const auto& [side, slow_s] : {std::pair{32, 0.15}, {64, 0.3}, {100, 0.5}})
    for (const std::string& method : allMethods())
      if (!quick || side == 32)
        registerSteps({"drape-2pin", side, kStiffness, kStep, 0.5, 15, quick ? 0.03 : slow_s},
                      settingsOf(method, quick));
}

}  // namespace

int main(int argc, char** argv) {
  return runBenchmarks(argc, argv, "drape_2pin", registerAll);
}
