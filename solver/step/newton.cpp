#include "solver/step/newton.h"

#include <fmt/format.h>

#include "solver/mesh/error.h"

namespace ease {

namespace {

constexpr double kLinearTolerance = 1e-2;  // of a Newton correction: well below the error of stopping after one
constexpr int kMostHalvings = 10;
constexpr double kRoundOff = 1e-12;  // of the potential: an increase that means nothing

// Vertices that are predicted deeper than a contact gives way start from where it does: from below, Newton's method on
// a spring that stiffens brings them only a third of the way out.
void liftOut(const std::vector<ContactPlane>& contacts, const std::vector<char>& fixed, Positions& x) {
  if (contacts.empty()) return;
  for (int i = 0; i < x.rows(); ++i) {
    const double excess = contacts[i].depth(x.row(i)) - contacts[i].give;
    if (excess > 0.0 && !fixed[i] && !contacts[i].held) x.row(i) += excess * contacts[i].normal;
  }
}

}  // namespace

NewtonStep::NewtonStep(const Cloth& cloth)
    : potential_(cloth),
      hessian_(cloth.vertexCount(), cloth.topology().edges),
      system_(hessian_),
      fixed_(cloth.vertexCount(), 0),
      gradient_(cloth.vertexCount(), 3) {}

void NewtonStep::holdPins(const Pins& pins, Positions& x) {
  std::vector<char> fixed(fixed_.size(), 0);
  for (size_t k = 0; k < pins.vertices.size(); ++k) {
    fixed[pins.vertices[k]] = 1;
    x.row(pins.vertices[k]) = pins.positions[k];
  }
  if (fixed != fixed_) system_.forgetFactor();
  fixed_.swap(fixed);
}

StepSummary NewtonStep::step(State& state, const StepOptions& options, const Pins& pins,
                             const FindContacts& find_contacts) {
  StepSummary summary;
  potential_.begin(state, options);
  x_ = state.positions + options.h * state.velocities;
  holdPins(pins, x_);
  find_contacts(x_, contacts_);
  potential_.setContacts(contacts_);
  liftOut(contacts_, fixed_, x_);

  potential_.gradient(x_, gradient_);
  potential_.hessian(x_, hessian_);
  potential_.prepareBending(x_);
  const SolveSummary solve = system_.solve(
      hessian_, [&](const Positions& d, Positions& product) { potential_.addBending(d, product); }, fixed_, -gradient_,
      kLinearTolerance, direction_);
  summary.newton_iterations = 1;
  summary.cg_iterations = solve.iterations;
  summary.factorisations = solve.factorisations;
  if (!solve.ok) throw ComputationError("the linear system of the step is not positive definite");

  const double before = potential_.value(x_) * (1.0 + kRoundOff);
  double scale = 1.0;
  for (trial_ = x_ + direction_; !(potential_.value(trial_) <= before); trial_ = x_ + scale * direction_) {
    if (++summary.halvings > kMostHalvings) throw ComputationError("no decrease of the potential along the step");
    scale *= 0.5;
  }

  state.velocities = (trial_ - state.positions) / options.h;
  state.positions = trial_;
  return summary;
}

}  // namespace ease
