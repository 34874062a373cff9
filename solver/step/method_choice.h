// Which of its two methods `auto` begins a step with: the one that has cost less lately.
//
// Costs are counted in iterations of pd-lbfgs, so that nothing depends on measured time and a run repeats to the last
// bit.  The method in use has a running mean.  The other is tried for one step now and then, ever more rarely while it
// loses, and only where a step costs enough for it to win.  pd-lbfgs hands over to Newton where it seems to have more
// left to do than Newton has cost lately.
#pragma once

namespace ease {

class MethodChoice {
 public:
  bool newtonFirst() const { return newton_ != trial_; }

  /// pd-lbfgs hands over to Newton if it predicts more iterations than this.
  int patience() const { return static_cast<int>(newton_cost_); }

  /// Records what a step cost, in pd-lbfgs iterations:
  /// `pd_lbfgs`: its own iterations.
  /// `newton`: Newton's iterations, converted; 0 if Newton was not used.
  /// `once`: factorisations, converted, which later steps may use again.
  void recordCost(double pd_lbfgs, double newton, double once);

 private:
  static constexpr int kFirstWait = 4;  // steps
  static constexpr double kFirstNewtonCost = 240.0;

  bool newton_ = false;                                          // the method in use; else pd-lbfgs
  bool trial_ = false;                                           // of the other, in the next step
  double mean_ = 0.0;                                            // cost of the method in use; 0: not known yet
  double once_ = 0.0;                                            // mean of what is paid once, since it is in use
  double other_ = 0.0;                                           // of pd-lbfgs when it was in use last
  double newton_cost_ = kFirstNewtonCost;                        // mean of steps that used it, with its factors
  int steps_ = 0;                                                // since the last trial
  int until_newton_ = kFirstWait, until_pd_lbfgs_ = kFirstWait;  // steps until the next trial
};

}  // namespace ease
