#include "solver/step/newton_system.h"

#include <cmath>
#include <utility>

#include "solver/linear/dot.h"

namespace ease {

namespace {

constexpr double kFactorCost = 35.0;  // a factorisation takes about as long as this many iterations
constexpr int kMaxIterations = 80;    // iterations with one factor before it is renewed
constexpr int kFewIterations = 8;     // a factor that needs no more iterations than this counts as near

}  // namespace

NewtonSystem::NewtonSystem(const BlockMatrix& pattern, std::span<const int> ordering)
    : cholesky_(Cholesky::Kind::kSupernodal) {
  const std::vector<char> fixed(pattern.rows(), 0);
  pattern.toScalar(fixed, scalar_);
  cholesky_.analyse(scalar_, liftOrdering(ordering));
  r_.resize(pattern.rows(), 3);
  z_ = p_ = product_ = r_;
}

bool NewtonSystem::factor(const BlockMatrix& matrix, std::span<const char> fixed) {
  matrix.toScalar(fixed, scalar_);
  factored_ = cholesky_.factor(scalar_);
  if (factored_) cholesky_.copyTo(panels_);
  preconditioned_ = false;
  solves_ = last_iterations_ = 0;
  cost_ = kFactorCost;
  return factored_;
}

bool NewtonSystem::factorIsNear() const {
  return factored_ && solves_ > 0 && last_iterations_ <= kFewIterations;
}

const Positions& NewtonSystem::precondition(const Positions& right) {
  r_ = right;
  precondition();
  preconditioned_ = true;
  return z_;
}

void NewtonSystem::precondition() {
  panels_.solve(r_.data(), z_.data(), 1);
}

SolveSummary NewtonSystem::solve(const BlockMatrix& matrix,
                                 const std::function<void(const Positions&, Positions&)>& add_product,
                                 std::span<const char> fixed, const Positions& right, double tolerance, Positions& d,
                                 int max_iterations) {
  SolveSummary summary;
  const auto renew = [&] {
    ++summary.factorisations;
    return factor(matrix, fixed);
  };
  const auto maskFixed = [&](Positions& v) {
    for (int i = 0; i < matrix.rows(); ++i)
      if (fixed[i]) v.row(i).setZero();
  };
  if (!factored_ || (solves_ > 0 && last_iterations_ > cost_ / solves_))
    if (!renew()) return {0, summary.factorisations, false};

  d.setZero(matrix.rows(), 3);
  if (!std::exchange(preconditioned_, false) || r_ != right) {
    r_ = right;
    maskFixed(r_);
    precondition();
  }
  p_ = z_;
  double rz = dot(r_, z_);
  const double goal = tolerance * tolerance * rz;
  for (int since_factor = 0; rz > goal && summary.iterations < max_iterations; ++summary.iterations, ++since_factor) {
    if (since_factor == kMaxIterations) {
      if (summary.factorisations > 0) break;  // round-off allows no better solution
      if (!renew()) return {summary.iterations, summary.factorisations, false};
      since_factor = 0;
      precondition();
      p_ = z_;
      rz = dot(r_, z_);
    }
    matrix.multiply(p_, product_);
    add_product(p_, product_);
    maskFixed(product_);
    const double curvature = dot(p_, product_);
    if (!(curvature > 0.0)) return {summary.iterations, summary.factorisations, false};
    const double alpha = rz / curvature;
    parallelFor(matrix.rows(), 1024, [&](int i) {
      d.row(i) += alpha * p_.row(i);
      r_.row(i) -= alpha * product_.row(i);
    });
    precondition();
    const double next = dot(r_, z_);
    parallelFor(matrix.rows(), 1024, [&](int i) { p_.row(i) = z_.row(i) + next / rz * p_.row(i); });
    rz = next;
  }
  summary.ok = std::isfinite(rz);
  ++solves_;
  last_iterations_ =
      rz > goal ? kMaxIterations : summary.iterations;  // an unfinished solve says that the factor is old
  cost_ += summary.iterations;
  return summary;
}

}  // namespace ease
