#include "bench/trajectory_curve.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "bench/step_error.h"
#include "solver/mesh/error.h"

namespace ease {

namespace {

using Clock = std::chrono::steady_clock;
using Snapshots = std::vector<Positions>;  // at common instants

constexpr int kFiner = 16;  // of the reference's steps, in the least time step of the curves
const MethodOptions kReference{Method::newton, 0.0, 1e-6, 0};

std::string nameOf(const TrajectoryCase& c) {
  return fmt::format("trajectory/sheet:{}/n:{}/k:{:g}", c.sheet, c.side * c.side, c.k);
}

/// Common instants are where the longest step ends.
Snapshots snapshots(const Sheet& sheet, const MethodOptions& options, const TrajectoryCase& c, int rate) {
  TimeStep step(sheet.cloth, options, sheet.ordering);
  State state = sheet.start;
  const int count = static_cast<int>(std::lround(c.duration * rate)), every = rate / c.rates.front();
  Snapshots taken;
  for (int n = 0; n < count; ++n) {
    advance(sheet, step, n / static_cast<double>(rate), 1.0 / rate, state);
    if ((n + 1) % every == 0) taken.push_back(state.positions);
  }
  return taken;
}

struct Reference {
  std::unique_ptr<Sheet> sheet;
  Snapshots exact;
};

/// Made when first asked for, and kept until another is.
const Reference& referenceOf(const TrajectoryCase& c) {
  static std::string name;
  static Reference reference;
  if (name != nameOf(c)) {
    reference.sheet = makeSheetNamed(c.sheet, c.side, c.k);
    const int finest = kFiner * c.rates.back();
    const Snapshots coarse = snapshots(*reference.sheet, kReference, c, finest / 2);
    reference.exact = snapshots(*reference.sheet, kReference, c, finest);
    for (size_t i = 0; i < coarse.size(); ++i) reference.exact[i] = 2.0 * reference.exact[i] - coarse[i];
    name = nameOf(c);
  }
  return reference;
}

void countErrors(benchmark::State& state, const Reference& reference, const Snapshots& x) {
  const Cloth& cloth = reference.sheet->cloth;
  double off = 0.0, moved = 0.0, mass = 0.0;
  for (size_t i = 0; i < x.size(); ++i) {
    off += std::pow(massNorm(cloth, x[i] - reference.exact[i]), 2);
    moved += std::pow(massNorm(cloth, reference.exact[i] - reference.sheet->start.positions), 2);
  }
  for (double m : cloth.masses()) mass += m;
  state.counters["error"] = std::sqrt(off / moved);
  state.counters["rms_mm"] = 1e3 * std::sqrt(off / (mass * static_cast<double>(x.size())));
}

struct Trial {
  TrajectoryCase trajectory;
  Setting setting;
  int rate;
  std::shared_ptr<double> slowest_s;  // of the method's settings so far
  bool started = false, too_slow = false;

  void operator()(benchmark::State& state) {
    const Reference& reference = referenceOf(trajectory);
    if (!started) too_slow = *slowest_s > trajectory.slow_s;
    started = true;
    if (too_slow) {
      state.SkipWithError(fmt::format("not tried: a looser setting takes more than {} s", trajectory.slow_s).c_str());
      return;
    }
    try {
      for (auto _ : state) {
        const Clock::time_point start = Clock::now();
        const Snapshots x = snapshots(*reference.sheet, setting.options, trajectory, rate);
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        state.SetIterationTime(seconds);
        *slowest_s = std::max(*slowest_s, seconds);
        countErrors(state, reference, x);
        state.counters["ms_per_step"] = 1e3 * seconds / std::round(trajectory.duration * rate);
      }
    } catch (const ComputationError& error) {
      state.SkipWithError(error.what());
    }
  }
};

}  // namespace

void registerTrajectories(const TrajectoryCase& trajectory, std::span<const Setting> settings) {
  for (int rate : trajectory.rates) {
    std::shared_ptr<double> slowest;
    std::string method;
    for (const Setting& setting : settings) {
      if (setting.method != method) slowest = std::make_shared<double>(0.0);
      method = setting.method;
      const auto trial = std::make_shared<Trial>(Trial{trajectory, setting, rate, slowest});
      const std::string name = fmt::format("{}/h:{:.4g}/method:{}/{}:{:g}", nameOf(trajectory), 1.0 / rate, method,
                                           setting.knob, setting.value);
      benchmark::RegisterBenchmark(name.c_str(), [trial](benchmark::State& state) { (*trial)(state); })
          ->Iterations(1)
          ->Repetitions(trajectory.runs)
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
    }
  }
}

}  // namespace ease
