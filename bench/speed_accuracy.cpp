// Speed against accuracy of every method: one implicit step on taut and on wrinkled cloth, and a whole trajectory.
//
//   speed_accuracy [--quick] [options of Google Benchmark]
//
// What an error is: step_error.h, trajectory_curve.h.  The sheets: sheets.h.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/program.h"
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
  registerSteps({"hanging", 32, 500.0, 1.0 / 60.0, 0.2, 15, 0.02}, settings);
  registerTrajectories({"taut", 16, 500.0, {30, 60}, 0.3, 3, 0.3}, settings);
}

/// The taut sheet: every k and h at 1k and 4k vertices, every k at 16k.  The hanging one, whose steps take many times
/// as long, along both axes through the middle at 1k, and the middle alone at 4k.
void registerFull() {
  const std::vector<Setting> settings = settingsOfAll(false), few = settingsOfAll(true);
  for (double k : {50.0, 500.0, 5000.0})
    for (double h : {1.0 / 240.0, 1.0 / 60.0, 1.0 / 30.0}) {
      registerSteps({"taut", 32, k, h, 0.2, 15, 0.1}, settings);
      registerSteps({"taut", 64, k, h, 0.2, 15, 0.2}, settings);
      if (h == 1.0 / 60.0) registerSteps({"taut", 128, k, h, 0.2, 15, 0.3}, settings);
      if (k == 500.0 || h == 1.0 / 60.0) registerSteps({"hanging", 32, k, h, 0.2, 15, 0.15}, few);
      if (k == 500.0 && h == 1.0 / 60.0) registerSteps({"hanging", 64, k, h, 0.2, 15, 0.3}, few);
    }
  for (double k : {50.0, 500.0, 5000.0}) registerTrajectories({"taut", 32, k, {30, 60, 240}, 0.3, 3, 2.0}, few);
}

}  // namespace

int main(int argc, char** argv) {
  return runBenchmarks(argc, argv, "speed_accuracy", [](bool quick) { quick ? registerQuick() : registerFull(); });
}
