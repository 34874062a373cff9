#include "bench/trajectory_curve.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <map>

#include "bench/program.h"
#include "bench/step_error.h"
#include "solver/base/error.h"
#include "solver/base/stopwatch.h"

namespace ease {

namespace {

using Clock = std::chrono::steady_clock;
using Snapshots = std::vector<Positions>;  // at the instants that all trajectories share

constexpr int kFiner = 16;  // steps of the reference per smallest time step of the curves
const MethodOptions kReference{Method::newton, 0.0, 1e-6, 0}, kRoundOff{Method::newton, 0.0, 1e-9, 0};

std::string nameOf(const TrajectoryCase& c) {
  return fmt::format("trajectory/sheet:{}/n:{}/k:{:g}", c.sheet, c.side * c.side, c.k);
}

/// Computes a trajectory and returns its positions at the shared instants, which are the ends of the longest time
/// steps.
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
  std::map<int, Snapshots> newton;  // Newton's method with the time step of each rate
};

/// Returns the reference of a case.  Computes it on the first request and keeps it until another case is requested.
const Reference& referenceOf(const TrajectoryCase& c) {
  static std::string name;
  static Reference reference;
  if (name != nameOf(c)) {
    reference.sheet = makeSheetNamed(c.sheet, c.side, c.k);
    const int finest = kFiner * c.rates.back();
    const Snapshots coarse = snapshots(*reference.sheet, kReference, c, finest / 2);
    reference.exact = snapshots(*reference.sheet, kReference, c, finest);
    for (size_t i = 0; i < coarse.size(); ++i) reference.exact[i] = 2.0 * reference.exact[i] - coarse[i];
    reference.newton.clear();
    for (int rate : c.rates) reference.newton[rate] = snapshots(*reference.sheet, kRoundOff, c, rate);
    name = nameOf(c);
  }
  return reference;
}

/// Returns sum_t |a - b|_M^2, kg m^2.
double squaredDistance(const Cloth& cloth, const Snapshots& a, const Snapshots& b) {
  double sum = 0.0;
  for (size_t i = 0; i < a.size(); ++i) sum += std::pow(massNorm(cloth, a[i] - b[i]), 2);
  return sum;
}

void countErrors(benchmark::State& state, const Reference& reference, int rate, const Snapshots& x) {
  const Cloth& cloth = reference.sheet->cloth;
  const double off = squaredDistance(cloth, x, reference.exact);
  const double moved = squaredDistance(cloth, reference.exact, Snapshots(x.size(), reference.sheet->start.positions));
  double mass = 0.0;
  for (double m : cloth.masses()) mass += m;
  state.counters["error"] = std::sqrt(off / moved);
  state.counters["method_error"] = std::sqrt(squaredDistance(cloth, x, reference.newton.at(rate)) / moved);
  state.counters["rms_mm"] = 1e3 * std::sqrt(off / (mass * static_cast<double>(x.size())));
}

struct Trial {
  TrajectoryCase trajectory;
  Setting setting;
  int rate;
  std::shared_ptr<double> slowest_s;  // longest time of the method's settings so far
  bool started = false, too_slow = false;
  int run = 0;
  double total_s = 0.0;

  void operator()(benchmark::State& state) {
    const Reference& reference = referenceOf(trajectory);
    if (!started) too_slow = *slowest_s > trajectory.slow_s;
    started = true;
    if (too_slow) {
      state.SkipWithError(fmt::format("not tried: a looser setting takes more than {} s", trajectory.slow_s).c_str());
      return;
    }
    for (auto _ : state) {
      if (run >= trajectory.least_runs && total_s > trajectory.enough_s) {
        tellNoResult(state, fmt::format("not repeated: {} runs took long enough", run), total_s / run);
        continue;
      }
      ++run;
      try {
        takeAll(reference, state);
      } catch (const ComputationError& error) {
        tellNoResult(state, error.what());
      }
    }
  }

  void takeAll(const Reference& reference, benchmark::State& state) {
    const Clock::time_point start = Clock::now();
    const Snapshots x = snapshots(*reference.sheet, setting.options, trajectory, rate);
    const double seconds = secondsSince(start);
    state.SetIterationTime(seconds);
    *slowest_s = std::max(*slowest_s, seconds);
    total_s += seconds;
    countErrors(state, reference, rate, x);
    state.counters["ms_per_step"] = 1e3 * seconds / std::round(trajectory.duration * rate);
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
