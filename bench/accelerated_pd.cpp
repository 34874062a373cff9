#include "bench/accelerated_pd.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/base/error.h"
#include "solver/base/parallel.h"
#include "solver/linear/dot.h"

namespace ease {

namespace {

constexpr int kDifferences = 5;
constexpr int kGrain = 1024;
constexpr int kPlain = 8;  // plain iterations before Chebyshev's weights are applied
// rho is measured over the last kWindow of at most kMeasured iterations, which end when the correction is shorter than
// kSmall times the first one.
constexpr size_t kMeasured = 150, kWindow = 20;
constexpr double kSmall = 1e-8, kMaxRate = 1.0 - 1e-6;

}  // namespace

AcceleratedPd::AcceleratedPd(const Cloth& cloth, Acceleration acceleration, int iterations,
                             std::span<const int> ordering)
    : acceleration_(acceleration),
      iterations_(iterations),
      potential_(cloth),
      system_(cloth.vertexCount(), cloth.triangles(), ordering, Cholesky::Kind::kSupernodal),
      fixed_(cloth.vertexCount(), 0),
      correction_(cloth.vertexCount(), 3) {}

void AcceleratedPd::factor(double h) {
  const Cloth& cloth = potential_.cloth();
  const Eigen::Vector2d weights = potential_.projectiveWeights();
  std::vector<double> diagonal(cloth.vertexCount());
  for (int i = 0; i < cloth.vertexCount(); ++i) diagonal[i] = cloth.masses()[i] / (h * h) + potential_.bendingBound(i);
  std::vector<Mat2> scaled_inverse(cloth.triangleCount());
  for (int t = 0; t < cloth.triangleCount(); ++t)
    scaled_inverse[t] = cloth.restInverse()[t] * weights.cwiseSqrt().asDiagonal();
  if (!system_.factor(scaled_inverse, cloth.membraneWeights(), diagonal, fixed_))
    throw ComputationError("the projective system is not positive definite");
}

void AcceleratedPd::findCorrection() {
  system_.solveRounded(point_.gradient, correction_);
  correction_ *= -1.0;
}

void AcceleratedPd::measureRate() {
  const Point start = point_;
  std::vector<double> lengths;
  do {
    findCorrection();
    lengths.push_back(correction_.norm());
    point_.x += correction_;
    point_.evaluate(potential_, fixed_);
  } while (lengths.size() < kMeasured && lengths.back() > kSmall * lengths.front());
  point_ = start;
  const size_t last = lengths.size() - 1, window = std::min(last, kWindow);
  rate_ = window > 0 ? std::pow(lengths[last] / lengths[last - window], 1.0 / static_cast<double>(window)) : 0.0;
  rate_ = std::min(rate_, kMaxRate);
}

void AcceleratedPd::anderson() {
  std::vector<Positions> d_target, d_correction;  // the last differences, in a ring
  Eigen::MatrixXd products(kDifferences, kDifferences);
  Positions target, last_target, last_correction;
  double last_energy = std::numeric_limits<double>::infinity();
  for (int k = 0; k < iterations_; ++k) {
    if (point_.energy > last_energy) {
      point_.x = target;
      point_.evaluate(potential_, fixed_);
    }
    last_energy = point_.energy;
    findCorrection();
    target = point_.x + correction_;
    if (k > 0) {
      const int slot = (k - 1) % kDifferences;
      d_target.resize(std::min(k, kDifferences));
      d_correction.resize(d_target.size());
      d_target[slot] = target - last_target;
      d_correction[slot] = correction_ - last_correction;
      for (size_t j = 0; j < d_correction.size(); ++j)
        products(slot, j) = products(j, slot) = dot(d_correction[slot], d_correction[j]);
    }
    last_target = target;
    last_correction = correction_;
    const int m = static_cast<int>(d_target.size());
    Eigen::VectorXd theta(m);
    for (int j = 0; j < m; ++j) theta[j] = dot(d_correction[j], correction_);
    if (m > 0) theta = products.topLeftCorner(m, m).completeOrthogonalDecomposition().solve(theta).eval();
    parallelFor(static_cast<int>(target.rows()), kGrain, [&](int i) {
      point_.x.row(i) = target.row(i);
      for (int j = 0; j < m; ++j) point_.x.row(i) -= theta[j] * d_target[j].row(i);
    });
    point_.evaluate(potential_, fixed_);
  }
  if (point_.energy > last_energy) point_.x = target;
}

void AcceleratedPd::chebyshev() {
  Positions before = point_.x;
  double weight = 1.0;
  for (int k = 0; k < iterations_; ++k) {
    findCorrection();
    if (k == kPlain) weight = 2.0 / (2.0 - rate_ * rate_);
    if (k > kPlain) weight = 4.0 / (4.0 - rate_ * rate_ * weight);
    Positions next = weight * (point_.x + correction_ - before) + before;
    before.swap(point_.x);
    point_.x.swap(next);
    point_.evaluate(potential_, fixed_);
  }
}

StepSummary AcceleratedPd::step(State& state, const StepOptions& options, const Pins& pins,
                                const FindContacts& find_contacts) {
  potential_.begin(state, options);
  point_.x = state.positions + options.h * state.velocities;
  std::fill(fixed_.begin(), fixed_.end(), 0);
  for (size_t k = 0; k < pins.vertices.size(); ++k) {
    fixed_[pins.vertices[k]] = 1;
    point_.x.row(pins.vertices[k]) = pins.positions[k];
  }
  Contacts contacts;
  find_contacts(point_.x, contacts);
  if (!contacts.planes.empty()) throw ComputationError("accelerated projective dynamics knows no contact");
  potential_.setContacts(contacts);
  point_.evaluate(potential_, fixed_);

  StepSummary summary;
  if (!prepared_) {
    factor(options.h);
    ++summary.factorisations;
    if (acceleration_ == Acceleration::chebyshev) measureRate();
    prepared_ = true;
  }
  if (acceleration_ == Acceleration::anderson)
    anderson();
  else
    chebyshev();
  summary.projective_iterations = iterations_;
  if (!point_.x.allFinite()) throw ComputationError("a position is not finite");
  state.velocities = (point_.x - state.positions) / options.h;
  state.positions = point_.x;
  return summary;
}

}  // namespace ease
