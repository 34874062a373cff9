// Maps over time step and stiffness of where each method, with its default settings, fails.
//
//   stability [--quick] [options of Google Benchmark]
//
// The sheets are the shaken taut and hanging sheets and the thrown one (sheets.h) with 256 vertices (quick: 144).  The
// method takes twelve steps (quick: eight) from the start.  The reference of each step is Newton's method from the same
// state, to a residual of 1e-5 m/s^2 (step_error.h).  Counters:
//
//   error          mean error of the steps.  The hanging sheet has several minima; there, a step counts with its error
//                  or the square root of its energy gap (for a quadratic energy: the error in the energy norm),
//                  whichever is smaller
//   of_start       mean, in the same way, of the error relative to the start of the step (step_error.h)
//   grade          2 converged: error at most 0.1
//                  1 degraded
//                  0 failed: no better than no step at all (`of_start` above 0.95), a position that is not finite or
//                    more than 1 km away, or a step that could not be completed
//   stopped        number of the step that failed, from 1; 0: none
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <optional>

#include "bench/program.h"
#include "bench/settings.h"
#include "bench/step_error.h"
#include "solver/base/error.h"
#include "solver/base/stopwatch.h"

using namespace ease;

namespace {

/// Number of vertices along an edge and number of steps.
struct Size {
  int side = 16, steps = 12;
};
constexpr double kFar = 1e3;                 // m: positions beyond this count as failure
constexpr double kReferenceResidual = 1e-5;  // m/s^2
constexpr double kConverged = 0.1, kUseless = 0.95;

enum Grade { kFailed = 0, kDegraded = 1, kGood = 2 };

struct Cell {
  Size size;
  std::string sheet;
  double h, k;  // s, N/m
  Setting setting;
};

/// Result of the steps of one cell of the map.
struct Outcome {
  double error = 0.0, of_start = 0.0, worst = 0.0, seconds = 0.0;
  int stopped = 0;        // number of the step that failed, from 1; 0: none
  bool reference = true;  // false: the reference solver failed
};

/// Returns `error`; for the hanging sheet, which has several minima, at most the square root of the energy gap.
double lesserError(const Cell& cell, double error, const StepError& e) {
  return cell.sheet == "hanging" ? std::min(error, std::sqrt(std::max(0.0, e.energy_gap))) : error;
}

bool isSane(const Positions& x) {
  return x.allFinite() && x.cwiseAbs().maxCoeff() < kFar;
}

Outcome runCell(const Cell& cell) {
  const auto sheet = makeSheetNamed(cell.sheet, cell.size.side, cell.k);
  TimeStep step(sheet->cloth, cell.setting.options, sheet->ordering);
  StepJudge judge(*sheet);
  ReferenceSolver reference(*sheet, kReferenceResidual);
  Outcome outcome;
  State state = sheet->start;
  for (int n = 0; n < cell.size.steps; ++n) {
    ReferenceStep exact{n * cell.h, state, {}};
    try {
      const auto start = std::chrono::steady_clock::now();
      advance(*sheet, step, n * cell.h, cell.h, state);
      outcome.seconds += secondsSince(start);
    } catch (const ComputationError&) {
      outcome.stopped = n + 1;
      return outcome;
    }
    if (!isSane(state.positions)) {
      outcome.stopped = n + 1;
      return outcome;
    }
    try {
      reference.findMinimum(cell.h, exact);
    } catch (const ComputationError&) {
      outcome.reference = false;
      return outcome;
    }
    const StepError judged = judge.judge(exact, cell.h, state.positions);
    const double error = lesserError(cell, judged.error, judged);
    outcome.error += error / cell.size.steps;
    outcome.of_start += lesserError(cell, judged.of_start, judged) / cell.size.steps;
    outcome.worst = std::max(outcome.worst, error);
  }
  return outcome;
}

void measureCell(benchmark::State& state, const Cell& cell) {
  for (auto _ : state) {
    const Outcome outcome = runCell(cell);
    if (!outcome.reference) return state.SkipWithError("the reference itself stopped");
    state.SetIterationTime(outcome.seconds / cell.size.steps);
    const bool useful = outcome.stopped == 0 && outcome.of_start <= kUseless;
    state.counters["grade"] = !useful ? kFailed : outcome.error <= kConverged ? kGood : kDegraded;
    state.counters["stopped"] = outcome.stopped;
    if (outcome.stopped > 0) continue;
    state.counters["error"] = outcome.error;
    state.counters["of_start"] = outcome.of_start;
    state.counters["worst"] = outcome.worst;
  }
}

void registerAll(bool quick) {
  const Size size = quick ? Size{12, 8} : Size{};
  std::vector<double> rates = {960, 480, 240, 120, 60, 30, 15, 10, 5}, stiffnesses = {1e2, 1e4, 1e6};
  if (quick) rates = {960, 60, 5};
  if (!quick) stiffnesses = {1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
  for (const char* sheet : {"taut", "hanging", "thrown"})
    for (const std::string& method : allMethods())
      for (double k : stiffnesses)
        for (double rate : rates) {
          const Cell cell{size, sheet, 1.0 / rate, k, defaultSettingOf(method)};
          const std::string name = fmt::format("stability/sheet:{}/n:{}/k:{:.4g}/h:{:.4g}/method:{}", sheet,
                                               size.side * size.side, k, 1.0 / rate, method);
          benchmark::RegisterBenchmark(name.c_str(), [cell](benchmark::State& state) { measureCell(state, cell); })
              ->Iterations(1)
              ->UseManualTime()
              ->Unit(benchmark::kMillisecond);
        }
}

}  // namespace

int main(int argc, char** argv) {
  return runBenchmarks(argc, argv, "stability", registerAll);
}
