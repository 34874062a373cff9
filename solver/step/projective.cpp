#include "solver/step/projective.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/base/error.h"

namespace ease {

namespace {

// Of contact's stiffness: beyond this drift A is factored again.
constexpr double kDrift = 0.5;
// Of contact's stiffness, what A has for pd-lbfgs: 0, .1 and 1 need 2.7, 1.5 and 1.1 times as many iterations.
constexpr double kContactAccelerated = 0.3;
// The error over the decrement that five pairs see, where it falls fast, and times its e-folds an iteration where it
// falls slowly.  Measured on a shirt in motion and on shaken sheets: errors asked to be .05 have a median of .02 to .04
// and nine in ten are below .061.
constexpr double kUnseen = 2.0, kUnseenSlow = 0.1;
constexpr double kMostUnseen = 60.0;
// Iterations over which the contraction is measured: for an error; for giving up, past where new contacts hold it up.
constexpr size_t kWindow = 8, kLongWindow = 24;

/// How the decrements have fallen in a window, in e-folds an iteration; infinite before that is known.
double contraction(const std::vector<double>& decrements, size_t window) {
  if (decrements.size() <= window) return std::numeric_limits<double>::infinity();
  return std::log(decrements[decrements.size() - 1 - window] / decrements.back()) / static_cast<double>(window);
}

/// Whether, at the rate of the last iterations, more are left than there is patience for.  A rate may yet rise: that is
/// not believed before half the patience is spent.
bool isHopeless(const std::vector<double>& decrements, const StopRule& stop) {
  if (2 * decrements.size() < static_cast<size_t>(stop.patience)) return false;
  const double left = std::log(kUnseen * decrements.back() / stop.error);  // e-folds
  return stop.patience > 0 && left > contraction(decrements, kLongWindow) * stop.patience;
}

/// Of the step, relative.
double estimatedError(const std::vector<double>& decrements) {
  const double rate = contraction(decrements, kWindow);
  return decrements.back() * (rate > 0.0 ? std::clamp(kUnseenSlow / rate, kUnseen, kMostUnseen) : kMostUnseen);
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
    double drift = 0.0, all = 0.0;
    for (size_t i = 0; i < contact_.size(); ++i) {
      drift += std::abs(contact_now_[i] - contact_[i]);
      all += std::max(contact_now_[i], contact_[i]);
    }
    same = drift <= kDrift * all;
  }
  if (same) return false;

  if (fixed_ != fixed) pairs_.clear();  // what was remembered moves vertices that are pinned now
  rest_revision_ = cloth.restRevision();
  h_ = h;
  weights_ = weights;
  fixed_ = fixed;
  accelerated_ = accelerated;
  contact_ = contact_now_;
  diagonal_.resize(cloth.vertexCount());
  for (int i = 0; i < cloth.vertexCount(); ++i) {
    diagonal_[i] = cloth.masses()[i] / (h * h) + (accelerated ? kContactAccelerated : 1.0) * contact_[i];
    if (!accelerated) diagonal_[i] += potential.bendingBound(i);
  }
  scaled_inverse_.resize(cloth.triangleCount());
  for (int t = 0; t < cloth.triangleCount(); ++t)
    scaled_inverse_[t] = cloth.restInverse()[t] * weights.cwiseSqrt().asDiagonal();
  if (!system_.factor(scaled_inverse_, cloth.restAreas(), diagonal_, fixed))
    throw ComputationError("the projective system is not positive definite");
  return true;
}

/// The next correction; returns its slope, gradient . direction.
double Projective::direct(const IncrementalPotential& potential, const Point& point) {
  pairs_.bend(point.gradient, direction_);
  system_.solveRounded(direction_, direction_);
  const double slope = pairs_.bendBack(point.gradient, direction_);
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
  for (; summary.iterations < stop.most_iterations; ++summary.iterations) {
    if (stop.acceleration > 0.0 && residualAcceleration(potential, point) <= stop.acceleration) {
      summary.converged = true;
      break;
    }
    double slope = direct(potential, point);
    if (!(slope < 0.0)) {
      pairs_.clear();
      slope = direct(potential, point);
      if (!(slope < 0.0)) break;
    }
    if (stop.error > 0.0) {
      decrements_.push_back(relativeDecrement(potential, point, slope));
      summary.converged = estimatedError(decrements_) <= stop.error;
      if (!stop.all && (summary.converged || isHopeless(decrements_, stop))) break;
    }
    const int halvings = searchAlong(potential, fixed, point, direction_, slope, next_);
    if (halvings < 0) {
      if (pairs_.empty()) break;
      pairs_.clear();  // what was remembered misleads
      continue;
    }
    summary.halvings += halvings;
    if (accelerated) pairs_.remember(point.x, point.gradient, next_.x, next_.gradient);
    std::swap(point, next_);
  }
  return summary;
}

}  // namespace ease
