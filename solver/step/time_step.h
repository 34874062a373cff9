// One implicit time step of the cloth, by the method that a scene chooses:
//
//   bw1        one Newton iteration
//   newton     Newton iterations down to a given residual
//   pd         a fixed number of local/global iterations of projective dynamics
//   pd-lbfgs   L-BFGS down to a given relative error; its initial Hessian is a matrix like that of `pd` (projective.h)
//   auto       pd-lbfgs or Newton down to a given relative error, whichever costs less (method_choice.h); the one hands
//              over to the other within the step where that seems to be cheaper
//
// All methods minimise the same incremental potential and start at x_n + h v_n. Contacts are found there. If a vertex
// then moves more than 4 mm, they are found again and the minimisation is repeated, up to four rounds in all; `bw1` has
// one round. From the third round on, a sample that moved that far in a round also stays above its nearest plane of
// that round: in a fold of the body it would otherwise go from one side to the other and back. Friction leaves these
// planes out. With friction, each minimisation takes the normal forces at the end of the last one, in this step or the
// one before.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "solver/step/method.h"
#include "solver/step/method_choice.h"
#include "solver/step/newton.h"
#include "solver/step/projective.h"

namespace ease {

/// Finds the contact plane of each sample of the cloth (model/contact.h) at positions x. Leaves the planes empty if
/// nothing can touch. `contacts` comes without second planes and motions; its first planes are those of the last call.
using FindContacts = std::function<void(const Positions& x, Contacts& contacts)>;

class TimeStep {
 public:
  /// Keeps a reference to the cloth, whose rest shape may change between steps. `ordering`: elimination order of the
  /// vertices (gradient_system.h).
  TimeStep(const Cloth& cloth, const MethodOptions& options, std::span<const int> ordering);

  /// Moves the state by one time step. If a system cannot be solved, or the potential or a position is not finite,
  /// throws ComputationError and leaves the state unchanged.
  StepSummary step(State& state, const StepOptions& options, const Pins& pins, const FindContacts& find_contacts);

  /// Makes the next step depend on its state alone, not on factors and secant pairs of earlier steps.
  void forget();

  IncrementalPotential& potential() { return potential_; }

 private:
  /// Sets fixed_ and the positions of the pinned vertices.
  void holdPins(const Pins& pins, Positions& x);
  void liftOut(Positions& x) const;
  /// Finds the contacts of a round, and adds the planes that are kept from earlier ones.
  void findContacts(const FindContacts& find_contacts);
  /// Keeps the nearest plane of each sample that has moved far since it was found.
  void keepPlanes();
  void minimise(StepSummary& summary);
  void newton(const StopRule& stop, StepSummary& summary);
  void projective(const StopRule& stop, bool accelerated, StepSummary& summary);

  const Cloth& cloth_;
  MethodOptions options_;
  IncrementalPotential potential_;
  std::optional<Newton> newton_;
  std::optional<Projective> projective_;
  MethodChoice choice_;  // used by auto
  std::vector<char> fixed_;
  Contacts contacts_;
  Positions found_at_;                            // positions at which the contacts were found, lifted out
  std::vector<Contacts::Second> kept_;            // planes of earlier rounds of this step
  std::vector<Vec3> samples_found_at_, samples_;  // m, where planes are kept
  Point point_;
};

}  // namespace ease
