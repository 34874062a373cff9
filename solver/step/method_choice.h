// Chooses the method with which `auto` begins a step, pd-lbfgs or Newton: the one that cost less in recent steps.
//
// Costs are counted in iterations of pd-lbfgs. Nothing depends on measured time, so a run repeats to the last bit.
// The method in use has a running mean of its cost. The other method is tried for one step now and then: more rarely
// each time it loses, and only when a step costs so much that the other can win. Within a step, pd-lbfgs hands over to
// Newton when it predicts that it needs more iterations than Newton has cost in recent steps.
#pragma once

namespace ease {

class MethodChoice {
 public:
  /// Whether the next step begins with Newton; otherwise it begins with pd-lbfgs.
  bool newtonFirst() const { return newton_ != trial_; }

  /// pd-lbfgs hands over to Newton if it predicts more iterations than this.
  int patience() const { return static_cast<int>(newton_cost_); }

  /// Records what a step cost, in pd-lbfgs iterations:
  /// `pd_lbfgs`: its own iterations.
  /// `newton`: Newton's iterations, converted; 0 if Newton was not used.
  /// `once`: factorisations, converted; they are counted apart because later steps may use them again.
  void recordCost(double pd_lbfgs, double newton, double once);

 private:
  static constexpr int kFirstWait = 4;  // steps
  static constexpr double kFirstNewtonCost = 240.0;

  bool newton_ = false;                    // whether Newton is in use; otherwise pd-lbfgs is
  bool trial_ = false;                     // whether the next step tries the other method
  double mean_ = 0.0;                      // running mean of the cost of the method in use; 0: unknown
  double once_ = 0.0;                      // running mean of `once` since the method is in use
  double other_ = 0.0;                     // mean cost of pd-lbfgs when it was last in use
  double newton_cost_ = kFirstNewtonCost;  // running mean over steps that used Newton, with `once`
  int steps_ = 0;                          // steps since the last trial
  int until_newton_ = kFirstWait, until_pd_lbfgs_ = kFirstWait;  // steps from a trial to the next
};

}  // namespace ease
