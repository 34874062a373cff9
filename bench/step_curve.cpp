#include "bench/step_curve.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <chrono>
#include <optional>

#include "bench/program.h"
#include "solver/base/error.h"
#include "solver/base/stopwatch.h"

namespace ease {

namespace {

using Clock = std::chrono::steady_clock;

std::string nameOf(const StepCase& c) {
  return fmt::format("step/sheet:{}/n:{}/k:{:g}/h:{:.4g}", c.sheet, c.side * c.side, c.k, c.h);
}

struct Reference {
  std::unique_ptr<Sheet> sheet;
  std::vector<ReferenceStep> steps;
};

/// Returns the reference of a case.  Computes it on the first request and keeps it until another case is requested.
const Reference& referenceOf(const StepCase& c) {
  static std::string name;
  static Reference reference;
  if (name != nameOf(c)) {
    reference.sheet = makeSheetNamed(c.sheet, c.side, c.k);
    reference.steps = referenceSteps(*reference.sheet, c.h, c.from_time, c.runs + 1);
    name = nameOf(c);
  }
  return reference;
}

/// State shared by the settings of one method, which are tried in order; those after a too slow one are skipped.
struct Sweep {
  double slowest_s = 0.0;  // largest mean time of a step of any setting so far, s
};

/// Measures one setting; each call is one repetition.
class Trial {
 public:
  Trial(const StepCase& step_case, const Setting& setting, std::shared_ptr<Sweep> sweep)
      : case_(step_case), setting_(setting), sweep_(std::move(sweep)) {}

  void operator()(benchmark::State& state) {
    const Reference& reference = referenceOf(case_);
    if (sweep_->slowest_s > case_.slow_s && run_ == 0) too_slow_ = true;
    if (too_slow_) {
      state.SkipWithError(fmt::format("not tried: a looser setting takes more than {} s a step", case_.slow_s).c_str());
      return;
    }
    for (auto _ : state) {
      try {
        if (run_ == 0) setUp(reference);
        if (failure_.empty()) takeStep(reference, state);
      } catch (const ComputationError& error) {
        failure_ = error.what();
      }
      if (!failure_.empty()) tellNoResult(state, failure_);
    }
    if (++run_ < case_.runs) return;
    sweep_->slowest_s = std::max(sweep_->slowest_s, total_s_ / case_.runs);
    step_.reset();
    accelerated_.reset();
    judge_.reset();
  }

 private:
  void setUp(const Reference& reference) {
    const Clock::time_point start = Clock::now();
    const Sheet& sheet = *reference.sheet;
    if (setting_.acceleration)
      accelerated_.emplace(sheet.cloth, *setting_.acceleration, setting_.options.iterations, sheet.ordering);
    else
      step_.emplace(sheet.cloth, setting_.options, sheet.ordering);
    State first = reference.steps.front().start;
    move(sheet, reference.steps.front(), first);
    setup_ms_ = 1e3 * secondsSince(start);
    judge_.emplace(*reference.sheet);
  }

  StepSummary move(const Sheet& sheet, const ReferenceStep& from, State& state) {
    return step_ ? advance(sheet, *step_, from.time, case_.h, state)
                 : advance(sheet, *accelerated_, from.time, case_.h, state);
  }

  void takeStep(const Reference& reference, benchmark::State& state) {
    const ReferenceStep& from = reference.steps[run_ + 1];
    State moved = from.start;
    const Clock::time_point start = Clock::now();
    const StepSummary summary = move(*reference.sheet, from, moved);
    const double seconds = secondsSince(start);
    state.SetIterationTime(seconds);
    total_s_ += seconds;

    const StepError e = judge_->judge(from, case_.h, moved.positions);
    auto& counters = state.counters;
    counters["error"] = e.error;
    counters["of_start"] = e.of_start;
    counters["energy_gap"] = e.energy_gap;
    counters["largest_mm"] = e.largest_mm;
    counters["residual_m_s2"] = e.residual_m_s2;
    counters["sigma_1_max_error"] = e.sigma_1_max_error;
    counters["sigma_1_p99_error"] = e.sigma_1_p99_error;
    counters["newton_iterations"] = summary.newton_iterations;
    counters["cg_iterations"] = summary.cg_iterations;
    counters["factorisations"] = summary.factorisations;
    counters["projective_iterations"] = summary.projective_iterations;
    counters["handed_over"] = static_cast<double>(summary.handed_over);
    counters["converged"] = summary.converged() ? 1.0 : 0.0;
    counters["setup_ms"] = setup_ms_;
  }

  StepCase case_;
  Setting setting_;
  std::shared_ptr<Sweep> sweep_;
  std::optional<TimeStep> step_;  // the method: either this or `accelerated_`
  std::optional<AcceleratedPd> accelerated_;
  std::optional<StepJudge> judge_;
  int run_ = 0;
  bool too_slow_ = false;
  std::string failure_;  // message of the first error, after which no step is taken
  double setup_ms_ = 0.0, total_s_ = 0.0;
};

}  // namespace

void registerSteps(const StepCase& step_case, std::span<const Setting> settings) {
  std::shared_ptr<Sweep> sweep;
  std::string method;
  for (const Setting& setting : settings) {
    if (setting.method != method) sweep = std::make_shared<Sweep>();
    method = setting.method;
    const auto trial = std::make_shared<Trial>(step_case, setting, sweep);
    const std::string name =
        fmt::format("{}/method:{}/{}:{:g}", nameOf(step_case), method, setting.knob, setting.value);
    benchmark::RegisterBenchmark(name.c_str(), [trial](benchmark::State& state) { (*trial)(state); })
        ->Iterations(1)
        ->Repetitions(step_case.runs)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace ease
