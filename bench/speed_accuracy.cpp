// Speed against accuracy of every method: one implicit step on taut and on wrinkled cloth, and a whole trajectory.
//
//   speed_accuracy [--quick] [options of Google Benchmark]
//
// Errors are defined in step_error.h and trajectory_curve.h, the sheets in sheets.h.
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

/// Removes the settings of newton and pd that are tighter than 1e-6 or take seconds on a large mesh.
std::vector<Setting> withoutTightest(std::vector<Setting> settings) {
  std::erase_if(settings, [](const Setting& s) {
    return (s.method == "newton" && s.value < 1e-2) || (s.method == "pd" && s.value > 100.0);
  });
  return settings;
}

std::vector<Setting> withAccelerated(std::vector<Setting> settings) {
  for (const std::string& method : acceleratedMethods())
    for (const Setting& setting : settingsOf(method, false)) settings.push_back(setting);
  return settings;
}

void registerQuick() {
  const std::vector<Setting> settings = settingsOfAll(true);
  for (double k : {50.0, 5000.0})
    for (double h : {1.0 / 240.0, 1.0 / 30.0})
      registerSteps({"taut", 32, k, h, 0.2, 15, 0.05}, withAccelerated(settings));
  registerSteps({"hanging", 32, 500.0, 1.0 / 60.0, 0.2, 15, 0.02}, settings);
  registerTrajectories(
      {.sheet = "taut", .side = 16, .k = 500.0, .rates = {30, 60}, .duration = 0.3, .enough_s = 0.1, .slow_s = 0.3},
      settings);
}

/// Registers single steps.  The taut sheet has every combination of k, h and n.  Steps of the hanging sheet take many
/// times as long: at 1k vertices only one of k and h differs from its middle value, at 4k neither.
void registerFullSteps() {
  const std::vector<Setting> settings = withAccelerated(settingsOfAll(false)), few = settingsOfAll(true);
  const std::vector<Setting> of_large = withoutTightest(settings);
  for (double k : {50.0, 500.0, 5000.0})
    for (double h : {1.0 / 240.0, 1.0 / 60.0, 1.0 / 30.0}) {
      registerSteps({"taut", 32, k, h, 0.2, 15, 0.1}, settings);
      registerSteps({"taut", 64, k, h, 0.2, 15, 0.2}, settings);
      registerSteps({"taut", 128, k, h, 0.2, 15, 0.4}, of_large);
      if (k == 500.0 || h == 1.0 / 60.0) registerSteps({"hanging", 32, k, h, 0.2, 15, 0.15}, few);
      if (k == 500.0 && h == 1.0 / 60.0) registerSteps({"hanging", 64, k, h, 0.2, 15, 0.3}, few);
    }
}

/// Registers trajectories of the taut sheet, with every k and h at 1k vertices.  References take four times as long at
/// 4k vertices and sixteen times at 16k: the shortest h is left out at both, and at 16k only the middle k is kept.
void registerFullTrajectories() {
  const std::vector<Setting> few = settingsOfAll(true);
  for (double k : {50.0, 500.0, 5000.0}) {
    registerTrajectories({.sheet = "taut", .side = 32, .k = k, .rates = {30, 60, 240}, .duration = 0.3, .slow_s = 2.0},
                         few);
    registerTrajectories({.sheet = "taut", .side = 64, .k = k, .rates = {30, 60}, .duration = 0.3, .slow_s = 2.0}, few);
  }
  registerTrajectories({.sheet = "taut", .side = 128, .k = 500.0, .rates = {30, 60}, .duration = 0.3, .slow_s = 1.0},
                       few);
}

void registerFull() {
  registerFullSteps();
  registerFullTrajectories();
}

}  // namespace

int main(int argc, char** argv) {
  return runBenchmarks(argc, argv, "speed_accuracy", [](bool quick) { quick ? registerQuick() : registerFull(); });
}
