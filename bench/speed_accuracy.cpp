// Speed against accuracy of every method: one implicit step on taut and on wrinkled cloth, and a whole trajectory.
//
//   speed_accuracy [--quick] [options of Google Benchmark]
//
// What an error is: step_error.h, trajectory_curve.h.  The sheets: sheets.h.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/arguments.h"
#include "bench/step_curve.h"
#include "bench/trajectory_curve.h"

using namespace ease;

namespace {

std::vector<Setting> settingsOfAll(bool coarse) {
  std::vector<Setting> all;
  for (const std::string& method : allMethods())
    for (const Setting& setting : settingsOf(method, coarse)) all.push_back(setting);
  return all;
}

void registerQuick() {
  const std::vector<Setting> settings = settingsOfAll(true);
  for (double k : {50.0, 5000.0})
    for (double h : {1.0 / 240.0, 1.0 / 30.0}) registerSteps({"taut", 32, k, h, 0.2, 15, 0.05}, settings);
  registerSteps({"hanging", 32, 500.0, 1.0 / 60.0, 0.2, 15, 0.05}, settings);
  registerTrajectories({"taut", 16, 500.0, {30, 60}, 0.3, 3, 1.0}, settings);
}

/// All of k and h at 4k vertices; at the other sizes what lies along the axes through the middle.
void registerFull() {
  const std::vector<Setting> settings = settingsOfAll(false);
  for (int side : {32, 64, 128})
    for (double k : {50.0, 500.0, 5000.0})
      for (double h : {1.0 / 240.0, 1.0 / 60.0, 1.0 / 30.0}) {
        const bool middle = k == 500.0 || h == 1.0 / 60.0;
        if (side != 128 || middle) registerSteps({"taut", side, k, h}, settings);
        if (side == 32 || (side == 64 && middle)) registerSteps({"hanging", side, k, h}, settings);
      }
  for (double k : {50.0, 500.0, 5000.0})
    registerTrajectories({"taut", 32, k, {30, 60, 240}, 0.3, 3, 10.0}, settingsOfAll(true));
}

}  // namespace

int main(int argc, char** argv) try {
  const bool quick = takeFlag(argc, argv, "quick");
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  quick ? registerQuick() : registerFull();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "speed_accuracy: {}\n", error.what());
  return 1;
}
