#include "solver/step/time_step.h"

#include <algorithm>
#include <cmath>

#include "solver/base/error.h"

namespace ease {

namespace {

// Upper bounds of the iterations in one minimisation.
constexpr int kMaxNewtonIterations = 100;
constexpr int kMaxProjectiveIterations = 1000;
// Costs in iterations of pd-lbfgs, measured with 1,000 to 16,000 vertices.
constexpr double kNewtonCost = 4.0;   // one Newton iteration without its linear solve
constexpr double kCgCost = 2.0;       // one iteration of conjugate gradients in Newton's method
constexpr double kFactorCost = 60.0;  // one factorisation of Newton's matrix
constexpr int kMaxContactRounds = 4;
constexpr double kStaleDistance = 4e-3;  // contacts are found again once a vertex has moved this far, m

}  // namespace

TimeStep::TimeStep(const Cloth& cloth, const MethodOptions& options, std::span<const int> ordering)
    : cloth_(cloth), options_(options), potential_(cloth), fixed_(cloth.vertexCount(), 0) {
  const Method method = options.method;
  if (method == Method::bw1 || method == Method::newton || method == Method::automatic)
    newton_.emplace(cloth, ordering);
  if (method == Method::pd || method == Method::pd_lbfgs || method == Method::automatic)
    projective_.emplace(cloth, ordering);
}

void TimeStep::holdPins(const Pins& pins, Positions& x) {
  std::fill(fixed_.begin(), fixed_.end(), 0);
  for (size_t k = 0; k < pins.vertices.size(); ++k) {
    fixed_[pins.vertices[k]] = 1;
    x.row(pins.vertices[k]) = pins.positions[k];
  }
}

/// Lifts each free vertex that is deeper than its contact's `give` up to that depth, as the start of the iteration.
/// From below, Newton's method on a stiffening spring would move it only a third of the way out per iteration.
void TimeStep::liftOut(Positions& x) const {
  if (contacts_.planes.empty()) return;
  const auto lift = [&](int i, const ContactPlane& plane) {
    const double excess = plane.depth(x.row(i)) - plane.give;
    if (excess > 0.0 && !fixed_[i]) x.row(i) += excess * plane.normal;
  };
  for (int i = 0; i < x.rows(); ++i) lift(i, contacts_.planes[i]);
  for (const Contacts::Second& second : contacts_.seconds)
    if (second.sample < x.rows()) lift(second.sample, second.plane);
}

void TimeStep::findContacts(const FindContacts& find_contacts) {
  contacts_.seconds.clear();
  contacts_.motions.clear();
  find_contacts(point_.x, contacts_);
  if (contacts_.planes.empty()) return;
  contacts_.seconds.insert(contacts_.seconds.end(), kept_.begin(), kept_.end());
}

void TimeStep::keepPlanes() {
  cloth_.samples().positions(found_at_, samples_found_at_);
  cloth_.samples().positions(point_.x, samples_);
  for (int s = 0; s < std::ssize(contacts_.planes); ++s) {
    if (contacts_.planes[s].normal.isZero(0.0) || (samples_[s] - samples_found_at_[s]).norm() <= kStaleDistance)
      continue;
    kept_.push_back({s, contacts_.planes[s], false});
  }
}

void TimeStep::newton(const StopRule& stop, StepSummary& summary) {
  const MinimiserSummary s = newton_->minimise(potential_, fixed_, stop, point_);
  summary.newton_iterations += s.iterations;
  summary.cg_iterations += s.cg_iterations;
  summary.factorisations += s.factorisations;
  summary.halvings += s.halvings;
  summary.short_of_tolerance = s.converged ? 0 : 1;
}

void TimeStep::projective(const StopRule& stop, bool accelerated, StepSummary& summary) {
  const MinimiserSummary s = projective_->minimise(potential_, fixed_, stop, accelerated, point_);
  summary.projective_iterations += s.iterations;
  summary.factorisations += s.factorisations;
  summary.halvings += s.halvings;
  summary.short_of_tolerance = s.converged ? 0 : 1;
}

void TimeStep::minimise(StepSummary& summary) {
  switch (options_.method) {
    case Method::bw1:
      return newton({1, options_.tolerance, 0.0, 0, true}, summary);
    case Method::newton:
      return newton({kMaxNewtonIterations, 0.0, options_.residual}, summary);
    case Method::pd:
      return projective({options_.iterations, options_.tolerance, 0.0, 0, true}, false, summary);
    case Method::pd_lbfgs:
      return projective({kMaxProjectiveIterations, options_.tolerance}, true, summary);
    case Method::automatic:
      break;
  }
  if (choice_.newtonFirst()) {
    const int patience = choice_.newtonPatience();
    newton({.max_iterations = kMaxNewtonIterations,
            .error = options_.tolerance,
            .max_cg_iterations = static_cast<int>(std::ceil(patience / kCgCost))},
           summary);
    if (summary.converged() || patience == 0) return;
  }
  projective({kMaxProjectiveIterations, options_.tolerance, 0.0, choice_.patience()}, true, summary);
  if (summary.converged()) return;
  summary.handed_over = 1;
  newton({kMaxNewtonIterations, options_.tolerance}, summary);
}

void TimeStep::forget() {
  if (newton_) newton_->forget();
  if (projective_) projective_->forget();
  choice_ = {};
}

StepSummary TimeStep::step(State& state, const StepOptions& options, const Pins& pins,
                           const FindContacts& find_contacts) {
  StepSummary summary;
  potential_.begin(state, options);
  point_.x = state.positions + options.h * state.velocities;
  holdPins(pins, point_.x);
  const bool has_friction = options.friction > 0.0;
  std::vector<double> normal_forces = has_friction ? state.normal_forces : std::vector<double>();
  bool forces_known = !has_friction || !normal_forces.empty();
  // Where no force is known, the first minimisation finds those that friction needs, and is repeated.
  const int max_rounds = (options_.method == Method::bw1 ? 1 : kMaxContactRounds) + (forces_known ? 0 : 1);
  kept_.clear();
  for (bool stale = true; stale && summary.contact_rounds < max_rounds;) {
    if (summary.contact_rounds >= 2) keepPlanes();
    ++summary.contact_rounds;
    findContacts(find_contacts);
    potential_.setContacts(contacts_, normal_forces);
    liftOut(point_.x);
    found_at_ = point_.x;
    point_.evaluate(potential_, fixed_);
    if (!std::isfinite(point_.energy)) throw ComputationError("the potential is not finite");
    minimise(summary);
    if (has_friction) potential_.normalForces(point_.x, normal_forces);
    stale = !contacts_.planes.empty() && (!forces_known || (point_.x - found_at_).rowwise().squaredNorm().maxCoeff() >
                                                               kStaleDistance * kStaleDistance);
    forces_known = true;
  }
  summary.kept_planes = std::ssize(kept_);
  if (options_.method == Method::automatic)
    choice_.recordCost(static_cast<double>(summary.projective_iterations),
                       kNewtonCost * static_cast<double>(summary.newton_iterations) +
                           kCgCost * static_cast<double>(summary.cg_iterations),
                       summary.newton_iterations > 0 ? kFactorCost * static_cast<double>(summary.factorisations) : 0.0);
  if (!point_.x.allFinite()) throw ComputationError("a position is not finite");
  state.velocities = (point_.x - state.positions) / options.h;
  state.positions = point_.x;
  state.normal_forces = std::move(normal_forces);
  return summary;
}

}  // namespace ease
