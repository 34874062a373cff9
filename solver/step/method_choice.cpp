#include "solver/step/method_choice.h"

#include <algorithm>
#include <utility>

namespace ease {

namespace {

// In iterations of pd-lbfgs. In a cheaper step the other method cannot win, since Newton's cheapest step costs 8.
constexpr double kMinCostForTrial = 12.0;
constexpr double kWeight = 0.25;                        // weight of the newest step in the running mean
constexpr double kFactorWeight = 0.05;                  // weight of the newest step in the mean of factorisation costs
constexpr int kWaitFactor = 4;                          // after a lost trial, wait four times as long
constexpr int kMinWaitForNewton = 64, kMaxWait = 4096;  // steps from a lost trial to the next one

}  // namespace

void MethodChoice::recordCost(double pd_lbfgs, double newton, double factors) {
  if (newton > 0.0) newton_cost_ += kWeight * (newton + factors - newton_cost_);
  const double cost = pd_lbfgs + newton;
  ++steps_;
  if (trial_) {
    trial_ = false;
    steps_ = 0;
    if (cost < mean_) {
      newton_ = !newton_;
      pd_lbfgs_mean_ = std::exchange(mean_, cost);
      factor_mean_ = 0.0;
      until_pd_lbfgs_ = kFirstWait;
    } else if (newton_) {
      until_pd_lbfgs_ = std::min(kWaitFactor * until_pd_lbfgs_, kMaxWait);
    } else {
      until_newton_ = std::clamp(kWaitFactor * until_newton_, kMinWaitForNewton, kMaxWait);
    }
    return;
  }
  mean_ += (mean_ == 0.0 ? 1.0 : kWeight) * (cost - mean_);
  factor_mean_ += kFactorWeight * (factors - factor_mean_);
  if (newton_ && mean_ + factor_mean_ > pd_lbfgs_mean_) {
    newton_ = false;
    mean_ = pd_lbfgs_mean_;
    steps_ = 0;
    until_newton_ = std::clamp(kWaitFactor * until_newton_, kMinWaitForNewton, kMaxWait);
  }
  trial_ = mean_ >= kMinCostForTrial && steps_ >= (newton_ ? until_pd_lbfgs_ : until_newton_);
}

}  // namespace ease
