// Where methods fail: a map over time step and stiffness, each method with its defaults.
//
//   stability [--quick] [options of Google Benchmark]
//
// On the taut and on the hanging sheet, 256 vertices, shaken; twenty steps of the method's own from rest, each step's
// error measured against Newton to round-off from the same state (step_error.h).  Counters:
//
//   error          mean over the steps; of the hanging sheet, which has several minima, of the lesser of the error and
//                  the square root of the energy gap (for a quadratic energy: the error in the energy's own norm)
//   grade          2 converged: error at most .1;  1 degraded: at most 1;  0 failed: worse than no step at all, a
//                  position that is not finite or 10 m away, or a step that stopped (`stopped`: at which)
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <optional>

#include "bench/arguments.h"
#include "bench/settings.h"
#include "bench/step_error.h"
#include "solver/mesh/error.h"

using namespace ease;

namespace {

constexpr int kSide = 16;
constexpr int kSteps = 20;
constexpr double kFar = 10.0;  // m
constexpr double kConverged = 0.1, kUseless = 1.0;

enum Grade { kFailed = 0, kDegraded = 1, kGood = 2 };

struct Cell {
  std::string sheet;
  double h, k;  // s, N/m
  Setting setting;
};

/// What twenty steps came to.
struct Outcome {
  double error = 0.0, worst = 0.0, seconds = 0.0;
  int stopped = 0;        // step, from 1; 0: none
  bool reference = true;  // false: the reference itself stopped
};

double errorOf(const Cell& cell, const StepError& e) {
  if (cell.sheet == "taut") return e.error;
  return std::min(e.error, std::sqrt(std::max(0.0, e.energy_gap)));
}

bool isSane(const Positions& x) {
  return x.allFinite() && x.cwiseAbs().maxCoeff() < kFar;
}

Outcome runCell(const Cell& cell) {
  const auto sheet = makeSheetNamed(cell.sheet, kSide, cell.k);
  TimeStep step(sheet->cloth, cell.setting.options, sheet->ordering);
  StepJudge judge(*sheet);
  Outcome outcome;
  State state = sheet->start;
  for (int n = 0; n < kSteps; ++n) {
    ReferenceStep reference{n * cell.h, state, {}};
    try {
      const auto start = std::chrono::steady_clock::now();
      advance(*sheet, step, n * cell.h, cell.h, state);
      outcome.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    } catch (const ComputationError&) {
      outcome.stopped = n + 1;
      return outcome;
    }
    if (!isSane(state.positions)) {
      outcome.stopped = n + 1;
      return outcome;
    }
    try {
      findMinimum(*sheet, cell.h, reference);
    } catch (const ComputationError&) {
      outcome.reference = false;
      return outcome;
    }
    const double error = errorOf(cell, judge.judge(reference, cell.h, state.positions));
    outcome.error += error / kSteps;
    outcome.worst = std::max(outcome.worst, error);
  }
  return outcome;
}

void measureCell(benchmark::State& state, const Cell& cell) {
  for (auto _ : state) {
    const Outcome outcome = runCell(cell);
    if (!outcome.reference) return state.SkipWithError("the reference itself stopped");
    state.SetIterationTime(outcome.seconds / kSteps);
    const bool useful = outcome.stopped == 0 && outcome.error <= kUseless;
    state.counters["grade"] = !useful ? kFailed : outcome.error <= kConverged ? kGood : kDegraded;
    state.counters["stopped"] = outcome.stopped;
    if (outcome.stopped > 0) continue;
    state.counters["error"] = outcome.error;
    state.counters["worst"] = outcome.worst;
  }
}

void registerAll(bool quick) {
  std::vector<double> rates = {960, 480, 240, 120, 60, 30, 15, 10, 5}, stiffnesses;
  if (quick) rates = {960, 240, 60, 20, 5};
  for (int half = 0; half <= 10; half += quick ? 2 : 1) stiffnesses.push_back(std::pow(10.0, 1.0 + 0.5 * half));
  for (const char* sheet : {"taut", "hanging"})
    for (const std::string& method : allMethods())
      for (double k : stiffnesses)
        for (double rate : rates) {
          const Cell cell{sheet, 1.0 / rate, k, defaultSettingOf(method)};
          const std::string name = fmt::format("stability/sheet:{}/n:{}/k:{:.4g}/h:{:.4g}/method:{}", sheet,
                                               kSide * kSide, k, 1.0 / rate, method);
          benchmark::RegisterBenchmark(name.c_str(), [cell](benchmark::State& state) { measureCell(state, cell); })
              ->Iterations(1)
              ->UseManualTime()
              ->Unit(benchmark::kMillisecond);
        }
}

}  // namespace

int main(int argc, char** argv) try {
  const bool quick = takeFlag(argc, argv, "quick");
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  registerAll(quick);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "stability: {}\n", error.what());
  return 1;
}
