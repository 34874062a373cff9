#include "solver/step/projective.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/base/error.h"

namespace ease {

namespace {

// A is factored again when the contact stiffness has changed by more than this share, and for pd-lbfgs already from
// kMinDrift on if the last solve took more iterations than the mean cost of a solve since A was factored, with that
// factor included (docs/numerics.md).
constexpr double kMaxDrift = 0.5, kMinDrift = 0.2;
constexpr double kFactorCost = 10.0;  // a factor takes about as long as this many iterations
// pd-lbfgs adds this share of the contact stiffness to A.
constexpr double kContactShare = 0.5;
// error ~ decrement x clamp(0.1 / rate, 2, 60), with the rate in e-folds per iteration. Fitted to a shirt in motion and
// shaken sheets: with a tolerance of 0.05 the true error has a median of 0.02 to 0.04, and nine in ten are below 0.061.
constexpr double kMinErrorFactor = 2.0, kErrorFactorTimesRate = 0.1;
constexpr double kMaxErrorFactor = 60.0;
// Number of iterations over which the rate is measured. Giving up uses the longer window, because new contacts slow
// down a few iterations.
constexpr size_t kWindow = 8, kLongWindow = 24;

/// Rate at which the decrements fell over the last `window` iterations, e-folds per iteration; infinite if there are
/// too few.
double contraction(const std::vector<double>& decrements, size_t window) {
  if (decrements.size() <= window) return std::numeric_limits<double>::infinity();
  return std::log(decrements[decrements.size() - 1 - window] / decrements.back()) / static_cast<double>(window);
}

/// Whether the rate of the last iterations predicts more of them than `patience`.  The rate may still rise, so the
/// answer is no until half of `patience` is spent.
bool isHopeless(const std::vector<double>& decrements, const StopRule& stop) {
  if (2 * decrements.size() < static_cast<size_t>(stop.patience)) return false;
  const double left = std::log(kMinErrorFactor * decrements.back() / stop.error);  // e-folds
  return stop.patience > 0 && left > contraction(decrements, kLongWindow) * stop.patience;
}

/// Estimates the relative error of the step (minimiser.h).
double estimatedError(const std::vector<double>& decrements) {
  const double rate = contraction(decrements, kWindow);
  return decrements.back() *
         (rate > 0.0 ? std::clamp(kErrorFactorTimesRate / rate, kMinErrorFactor, kMaxErrorFactor) : kMaxErrorFactor);
}

}  // namespace

Projective::Projective(const Cloth& cloth, std::span<const int> ordering)
    : system_(cloth.vertexCount(), cloth.triangles(), ordering, Cholesky::Kind::kSupernodal),
      direction_(cloth.vertexCount(), 3) {}

bool Projective::prepare(IncrementalPotential& potential, const std::vector<char>& fixed, bool accelerated,
                         const Positions& x) {
  const Cloth& cloth = potential.cloth();
  const double h = potential.options().h;
  const Eigen::Vector2d weights = potential.projectiveWeights();
  potential.contactDiagonal(x, !accelerated, contact_now_);
  bool same = rest_revision_ == cloth.restRevision() && h_ == h && weights_ == weights && fixed_ == fixed &&
              accelerated_ == accelerated;
  if (same) {
    double drift = 0.0, total = 0.0;
    for (size_t i = 0; i < contact_.size(); ++i) {
      drift += std::abs(contact_now_[i] - contact_[i]);
      total += std::max(contact_now_[i], contact_[i]);
    }
    const bool pays = accelerated && solves_ > 0 && last_iterations_ > (kFactorCost + iterations_) / solves_;
    same = drift <= (pays ? kMinDrift : kMaxDrift) * total;
  }
  if (same) return false;

  if (fixed_ != fixed) pairs_.clear();  // the stored pairs move vertices that are now pinned
  solves_ = iterations_ = last_iterations_ = 0;
  rest_revision_ = cloth.restRevision();
  h_ = h;
  weights_ = weights;
  fixed_ = fixed;
  accelerated_ = accelerated;
  contact_ = contact_now_;
  diagonal_.resize(cloth.vertexCount());
  for (int i = 0; i < cloth.vertexCount(); ++i) {
    diagonal_[i] = cloth.masses()[i] / (h * h) + (accelerated ? kContactShare : 1.0) * contact_[i];
    if (!accelerated) diagonal_[i] += potential.bendingBound(i);
  }
  scaled_inverse_.resize(cloth.triangleCount());
  for (int t = 0; t < cloth.triangleCount(); ++t) {
    const Eigen::Vector2d triangle_weights = accelerated ? potential.projectiveWeightsAt(x, t) : weights;
    scaled_inverse_[t] = cloth.restInverse()[t] * triangle_weights.cwiseSqrt().asDiagonal();
  }
  if (!system_.factor(scaled_inverse_, cloth.membraneWeights(), diagonal_, fixed))
    throw ComputationError("the projective system is not positive definite");
  return true;
}

/// Solves for the next search direction; returns its slope, gradient . direction, J.
double Projective::solveForDirection(const IncrementalPotential& potential, const Point& point) {
  pairs_.applyFirstLoop(point.gradient, direction_);
  system_.solveRounded(direction_, direction_);
  const double slope = pairs_.applySecondLoop(point.gradient, direction_);
  return slope + setMeanMotion(potential, fixed_, point, direction_);
}

MinimiserSummary Projective::minimise(IncrementalPotential& potential, const std::vector<char>& fixed,
                                      const StopRule& stop, bool accelerated, Point& point) {
  MinimiserSummary summary;
  decrements_.clear();
  if (!accelerated) pairs_.clear();
  if (prepare(potential, fixed, accelerated, point.x)) {
    ++summary.factorisations;
  }
  for (; summary.iterations < stop.max_iterations; ++summary.iterations) {
    if (stop.acceleration > 0.0 && residualAcceleration(potential, point) <= stop.acceleration) {
      summary.converged = true;
      break;
    }
    double slope = solveForDirection(potential, point);
    if (!(slope < 0.0)) {
      pairs_.clear();
      slope = solveForDirection(potential, point);
      if (!(slope < 0.0)) break;
    }
    if (stop.error > 0.0) {
      decrements_.push_back(relativeDecrement(potential, point, slope));
      summary.converged = estimatedError(decrements_) <= stop.error;
      if (!stop.run_all_iterations && (summary.converged || isHopeless(decrements_, stop))) break;
    }
    const int halvings = searchAlong(potential, fixed, point, direction_, slope, next_);
    if (halvings < 0) {
      if (pairs_.empty()) break;
      pairs_.clear();  // drop stored pairs that gave a bad direction, and retry
      continue;
    }
    summary.halvings += halvings;
    if (accelerated) pairs_.remember(point.x, point.gradient, next_.x, next_.gradient);
    std::swap(point, next_);
  }
  ++solves_;
  iterations_ += summary.iterations;
  last_iterations_ = summary.iterations;
  return summary;
}

}  // namespace ease
