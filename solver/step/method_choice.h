// Chooses the method with which `auto` begins a step, pd-lbfgs or Newton: the one that cost less in recent steps.
//
// Costs are counted in iterations of pd-lbfgs. Nothing depends on measured time, so a run repeats to the last bit.
// The method in use has a running mean of its cost. The other method is tried for one step now and then: more rarely
// each time it loses, and only when a step costs so much that the other can win. Within a step, pd-lbfgs hands over to
// Newton when it predicts that it needs more iterations than Newton has cost in recent steps, and a trial of Newton
// ends, for pd-lbfgs to finish the step, when it has cost as much as pd-lbfgs does.
#pragma once

#include <algorithm>

namespace ease {

class MethodChoice {
 public:
  /// Whether the next step begins with Newton; otherwise it begins with pd-lbfgs.
  bool newtonFirst() const { return newton_ != trial_; }  // a trial swaps the two

  /// pd-lbfgs hands over to Newton if it predicts more iterations than this.
  int patience() const { return static_cast<int>(newton_cost_); }

  /// In a trial Newton stops once it has cost this many iterations of pd-lbfgs, which has then been cheaper, and
  /// pd-lbfgs finishes the step; 0: Newton may cost any number.
  int newtonPatience() const { return trial_ && !newton_ ? std::max(1, static_cast<int>(mean_)) : 0; }

  /// Records what a step cost, in pd-lbfgs iterations:
  /// `pd_lbfgs`: its own iterations.
  /// `newton`: Newton's iterations, converted; 0 if Newton was not used.
  /// `factors`: factorisations, converted; they are counted apart because later steps may use them again.
  void recordCost(double pd_lbfgs, double newton, double factors);

 private:
  static constexpr int kFirstWait = 4;  // steps
  static constexpr double kFirstNewtonCost = 240.0;

  bool newton_ = false;                    // whether Newton is in use; otherwise pd-lbfgs is
  bool trial_ = false;                     // whether the next step tries the other method
  double mean_ = 0.0;                      // running mean of the cost of the method in use; 0: unknown
  double factor_mean_ = 0.0;               // running mean of the cost of factors since the method is in use
  double pd_lbfgs_mean_ = 0.0;             // mean cost of pd-lbfgs when it was last in use
  double newton_cost_ = kFirstNewtonCost;  // running mean over steps that used Newton, with factors
  int steps_ = 0;                          // steps since the last trial
  int until_newton_ = kFirstWait, until_pd_lbfgs_ = kFirstWait;  // steps from a trial to the next
};

}  // namespace ease
