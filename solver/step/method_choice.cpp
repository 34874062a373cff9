#include "solver/step/method_choice.h"

#include <algorithm>
#include <utility>

namespace ease {

namespace {

constexpr double kWorthATrial = 12.0;  // cost of a step: of Newton's least, an iteration with a few of CG, 8
constexpr double kWeight = 0.25;       // of a step in the running mean
constexpr double kOnceWeight = 0.05;   // of what it costs once
constexpr int kRarer = 4;              // times, after a trial that was lost
constexpr int kLeastForNewton = 64, kMost = 4096;  // steps from a trial that was lost to the next

}  // namespace

void MethodChoice::took(double pd_lbfgs, double newton, double once) {
  if (newton > 0.0) newton_cost_ += kWeight * (newton + once - newton_cost_);
  const double cost = pd_lbfgs + newton;
  ++steps_;
  if (trial_) {
    trial_ = false;
    steps_ = 0;
    if (cost < mean_) {
      newton_ = !newton_;
      other_ = std::exchange(mean_, cost);
      once_ = 0.0;
      until_pd_lbfgs_ = kFirstWait;
    } else if (newton_) {
      until_pd_lbfgs_ = std::min(kRarer * until_pd_lbfgs_, kMost);
    } else {
      until_newton_ = std::clamp(kRarer * until_newton_, kLeastForNewton, kMost);
    }
    return;
  }
  mean_ += (mean_ == 0.0 ? 1.0 : kWeight) * (cost - mean_);
  once_ += kOnceWeight * (once - once_);
  if (newton_ && mean_ + once_ > other_) {
    newton_ = false;
    mean_ = other_;
    steps_ = 0;
    until_newton_ = std::clamp(kRarer * until_newton_, kLeastForNewton, kMost);
  }
  trial_ = mean_ >= kWorthATrial && steps_ >= (newton_ ? until_pd_lbfgs_ : until_newton_);
}

}  // namespace ease
