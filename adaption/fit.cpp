#include "adaption/fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "adaption/stitch.h"
#include "solver/base/error.h"
#include "solver/base/joined.h"

namespace ease {

namespace {

constexpr double kDisturbance = 1e-5;  // m: of the start of the check
constexpr int kPassesWithoutGain = 5;  // after that many the fit ends
constexpr double kFar = 0.01;          // share over the limit above which a pass is far from the target
constexpr double kCoarser = 2.0;       // tolerance of the pass after it over the one that was asked for
// Strain to which cloth grows near the target, as a share of the limit.  Near the target, different triangles of
// crumpled cloth are over the limit in every pass; with more room fewer are.
constexpr double kGoalNearTarget = 0.3;

double areaOf(const Cloth& cloth) {
  return std::accumulate(cloth.restAreas().begin(), cloth.restAreas().end(), 0.0);
}

/// The start, each coordinate moved by at most the disturbance, differently from its neighbours'.
Positions disturbed(const Positions& start) {
  Positions x = start;
  for (int k = 0; k < x.size(); ++k) x.data()[k] += kDisturbance * std::sin(1.0 + 12.9898 * k);
  return x;
}

/// Whether the pass after these is far from the target.
bool isFar(std::span<const FitPass> before) {
  return before.empty() || before.back().record.stretch.overall.share_over_limit > kFar;
}

}  // namespace

double toleranceOfPass(std::span<const FitPass> before, double asked) {
  return isFar(before) ? kCoarser * asked : asked;
}

Fit::Fit(const RunSettings& settings, const FitSettings& fit, const RunInput& input, Cloth& cloth)
    : settings_(settings), fit_(fit), input_(input), cloth_(cloth), demand_(*settings.limit) {
  if (input_.ordering.empty()) input_.ordering = systemOrdering(cloth_.vertexCount(), cloth_.triangles());
  cloth_.setRest(RestShape(cloth_.first()));
  first_area_ = areaOf(cloth_);
}

void Fit::run(const FitWatch& watch) {
  if (!state_.next_rest.empty()) setMetric(state_.next_rest);
  try {
    do {
      while (!state_.over && passCount() < fit_.max_passes && !isInterrupted(watch)) pass(watch);
    } while (!isInterrupted(watch) && !check(watch));
  } catch (const ComputationError&) {
    embed();
    throw;
  }
  if (isInterrupted(watch)) embed();
}

void Fit::embed() {
  const std::vector<Mat2> metric = cloth_.restEdges();
  if (metric == cloth_.first().edges) {  // nothing grew: the surface that has this metric is known
    cloth_.setRest(RestShape(cloth_.first()));
    return;
  }
  // From the first rest shape, not from what an earlier check embedded, which a fit that goes on does not know.
  cloth_.setRest({cloth_.first().positions, metric});
  Stitcher stitcher(cloth_, input_.ordering);
  cloth_.setRest({stitcher.embed(cloth_), metric});
  result_.embedding = metricError(cloth_, cloth_.restPositions());
}

GrowthDemand Fit::demandOfNextPass() const {
  return GrowthDemand(*settings_.limit, isFar(state_.passes) ? kGoal : kGoalNearTarget);
}

void Fit::pass(const FitWatch& watch) {
  demand_ = demandOfNextPass();
  RunWatch run_watch = watch.of_pass ? watch.of_pass(passCount() + 1) : RunWatch();
  run_watch.interrupted = watch.interrupted;
  run_watch.on_stretch = [&](const std::vector<Stretch>& stretch) { demand_.add(cloth_, stretch); };
  RunSettings settings = settings_;
  settings.method.tolerance = toleranceOfPass(state_.passes, settings.method.tolerance);
  Run run(settings, input_, cloth_);
  run.run(run_watch);
  if (isInterrupted(watch)) return;
  FitPass done{run.record(), areaOf(cloth_) / first_area_};
  done.record.fully_grown = demand_.fullyGrown();
  state_.passes.push_back(done);
  if (state_.passes.size() == 1) state_.first_end = run.state().positions;
  chooseNext();
  if (watch.on_pass) watch.on_pass(state_);
}

/// Chooses the rest shape of the next pass, or ends the passes.
void Fit::chooseNext() {
  const int now = passCount() - 1;
  if (share(now) <= state_.best_share) {
    state_.best = now;
    state_.best_share = share(now);
    state_.best_rest = cloth_.restEdges();
  }
  state_.over = share(now) <= fit_.target || now - state_.best >= kPassesWithoutGain;
  if (!state_.over) state_.over = !demand_.letOut(cloth_);
  state_.next_rest = cloth_.restEdges();
}

/// Embeds and checks the best rest shape.  Returns false where the check missed the target and passes are left, which
/// then start from what this rest shape asked for.
bool Fit::check(const FitWatch& watch) {
  setMetric(state_.best_rest);
  embed();

  demand_ = demandOfNextPass();  // what follows must not depend on whether the last pass was resumed
  RunWatch run_watch = watch.of_check ? watch.of_check() : RunWatch();
  run_watch.interrupted = watch.interrupted;
  run_watch.on_stretch = [&](const std::vector<Stretch>& stretch) { demand_.add(cloth_, stretch); };
  RunInput input = input_;
  input.start = disturbed(input_.start);
  Run run(settings_, input, cloth_);
  run.run(run_watch);
  if (isInterrupted(watch)) return true;
  result_.check = run.record();
  result_.check_end = run.state().positions;

  const bool pass_met_target = state_.best_share <= fit_.target;
  state_.best_share = std::max(share(state_.best), result_.check.stretch.overall.share_over_limit);
  result_.target_met = state_.best_share <= fit_.target;
  const int passes = passCount();
  if (result_.target_met) {
    result_.reason = "the target is met";
    return true;
  }
  const bool passes_left = pass_met_target && passes < fit_.max_passes;
  if (passes_left && demand_.letOut(cloth_)) {
    state_.over = false;
    state_.next_rest = cloth_.restEdges();
    return false;
  }
  result_.reason = passes >= fit_.max_passes ? joined("all ", passes, " passes were made")
                                             : std::string("the share over the limit no longer fell");
  return true;
}

}  // namespace ease
