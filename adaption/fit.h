// Fits the rest shape to the whole motion of the body, in passes.
//
//   pass 1       carries the cloth once through the motion on its first rest shape
//   let out      the rest shape grows as all moments of the pass ask for (growth_demand.h)
//   pass 2 ...   the same again, until the share of triangles over the limit is at most the target, or no longer falls
//   embedding    a surface in space with the lengths of the chosen metric (rest_metric.h)
//   check        a last pass on the rest shape chosen, from a start that is disturbed by a hundredth of a millimetre
//
// Every pass but the first also verifies the rest shape that the pass before it let out; only the check does nothing
// else. Where cloth crumples, the smallest disturbance changes its folds and with them the share over the limit. The
// larger share of the chosen pass and the check therefore counts.
#pragma once

#include <span>
#include <vector>

#include "adaption/fit_state.h"
#include "adaption/growth_demand.h"
#include "adaption/run.h"

namespace ease {

/// Who watches a fit.  Functions may be empty.
struct FitWatch {
  std::function<RunWatch(int pass)> of_pass;     // who watches a pass, from 1
  std::function<RunWatch()> of_check;            // called before the check, again where another check follows
  std::function<void(const FitState&)> on_pass;  // after each pass: a later fit may go on from here
  const std::atomic<bool>* interrupted = nullptr;
};

/// Tolerance to which the pass after these solves its steps, where `asked` is that of the run: twice as much in the
/// first pass and after one with a share over the limit above 1 %, since what such a pass asks for is coarse anyway.
double toleranceOfPass(std::span<const FitPass> before, double asked);

class Fit {
 public:
  /// `settings.limit` must be set; the passes follow `settings.schedule`, without adaption on the way.
  Fit(const RunSettings& settings, const FitSettings& fit, const RunInput& input, Cloth& cloth);

  /// Goes on from there.  Must come before run().  `is_alike`: the passes so far were made with the same limit, cloth
  /// and contact; otherwise their shares over the limit do not count, and one more pass is made if any is left.
  void resume(const FitState& from, bool is_alike) {
    state_ = from;
    state_.resumed_after = passCount();
    if (is_alike) return;
    state_.best_share = 1.0;
    state_.over = false;
  }

  /// Fits the cloth's rest shape.  Where it is interrupted, or throws ComputationError as Run::run() does, the cloth
  /// has the rest shape of the pass that was not finished, embedded too.
  void run(const FitWatch& watch);

  const FitState& state() const { return state_; }
  const FitResult& result() const { return result_; }

 private:
  bool isInterrupted(const FitWatch& watch) const { return watch.interrupted && *watch.interrupted; }
  GrowthDemand demandOfNextPass() const;
  void pass(const FitWatch& watch);
  void chooseNext();
  bool check(const FitWatch& watch);
  void embed();
  int passCount() const { return static_cast<int>(state_.passes.size()); }
  double share(int pass) const { return state_.passes[pass].record.stretch.overall.share_over_limit; }
  void setMetric(const std::vector<Mat2>& edges) { cloth_.setRest({cloth_.restPositions(), edges}); }

  const RunSettings settings_;
  const FitSettings fit_;
  RunInput input_;  // with its ordering
  Cloth& cloth_;
  double first_area_;  // m^2
  GrowthDemand demand_;
  FitState state_;
  FitResult result_;
};

}  // namespace ease
