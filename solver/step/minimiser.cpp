#include "solver/step/minimiser.h"

#include <algorithm>
#include <cmath>

#include "solver/base/parallel.h"
#include "solver/linear/dot.h"

namespace ease {

namespace {

constexpr int kGrain = 1024;
constexpr int kMaxHalvings = 20;
constexpr double kSufficientDecrease = 1e-4;  // share of the decrease predicted by the slope (Armijo's condition)
constexpr double kForcedMotionFactor = 4.0;   // the 4 in the error's denominator (minimiser.h)
constexpr double kMinSpeed = 1e-3;            // v_min in the error's denominator (minimiser.h), m/s

/// Square of the relative error's denominator (minimiser.h) divided by h^2, which is twice a kinetic energy, J.
double stepKinetic(const IncrementalPotential& potential, const StepMotion& motion) {
  const double least = potential.totalMass() * kMinSpeed * kMinSpeed;
  return std::min(motion.whole, kForcedMotionFactor * kForcedMotionFactor * motion.forced) + least;
}

}  // namespace

void Point::evaluate(IncrementalPotential& potential, const std::vector<char>& fixed) {
  gradient.resize(x.rows(), 3);
  energy = potential.gradient(x, gradient, &motion);
  for (int i = 0; i < x.rows(); ++i)
    if (fixed[i]) gradient.row(i).setZero();
}

double residualAcceleration(const IncrementalPotential& potential, const Point& point) {
  double largest = 0.0;
  for (int i = 0; i < point.gradient.rows(); ++i)
    largest = std::max(largest, point.gradient.row(i).squaredNorm() / std::pow(potential.cloth().masses()[i], 2));
  return std::sqrt(largest);
}

double relativeDecrement(const IncrementalPotential& potential, const Point& point, double slope) {
  return std::sqrt(std::max(0.0, -slope) / stepKinetic(potential, point.motion));
}

double relativeLength(const IncrementalPotential& potential, const Point& point, const Positions& direction) {
  return std::sqrt(potential.kinetic(direction) / stepKinetic(potential, point.motion));
}

double setMeanMotion(const IncrementalPotential& potential, const std::vector<char>& fixed, const Point& point,
                     Positions& direction) {
  if (potential.mayTouch() || std::find(fixed.begin(), fixed.end(), 1) != fixed.end()) return 0.0;
  const std::vector<double>& masses = potential.cloth().masses();
  const double h = potential.options().h;
  Eigen::RowVector3d force = Eigen::RowVector3d::Zero();   // sum of the gradient, N
  Eigen::RowVector3d moment = Eigen::RowVector3d::Zero();  // sum_i m_i d_i, kg m
  for (int i = 0; i < direction.rows(); ++i) {
    force += point.gradient.row(i);
    moment += masses[i] * direction.row(i);
  }
  const Eigen::RowVector3d shift = -(h * h * force + moment) / potential.totalMass();
  direction.rowwise() += shift;
  return force.dot(shift);
}

int searchAlong(IncrementalPotential& potential, const std::vector<char>& fixed, const Point& point,
                const Positions& direction, double slope, Point& next) {
  const double round_off = potential.roundOff(point.energy, point.motion);
  double scale = 1.0;
  for (int halvings = 0; halvings <= kMaxHalvings; ++halvings, scale *= 0.5) {
    next.x.resize(point.x.rows(), 3);
    parallelFor(static_cast<int>(point.x.rows()), kGrain,
                [&](int i) { next.x.row(i) = point.x.row(i) + scale * direction.row(i); });
    next.evaluate(potential, fixed);
    const double change = next.energy - point.energy;
    if (change <= kSufficientDecrease * scale * slope) return halvings;
    const bool lost = std::abs(change) <= round_off;
    if (lost && std::abs(dot(next.gradient, direction)) <= 0.9 * std::abs(slope)) return halvings;
  }
  return -1;
}

}  // namespace ease
