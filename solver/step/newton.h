// The Baraff-Witkin step (`bw1`): one Newton iteration on the incremental potential.
//
// Baraff and Witkin 1998 linearise at the start of the step, x_n; from x_n + h v_n the same work leaves a seventh of
// the error, so that is where it starts.  Contacts are found there.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solver/step/incremental_potential.h"
#include "solver/step/newton_system.h"

namespace ease {

/// Vertices held at given positions, exactly.
struct Pins {
  std::vector<int> vertices;
  std::vector<Vec3> positions;  // at the end of the step, m
};

/// Fills a plane for each sample of the cloth (contact.h) at these positions; leaves the vector empty where nothing can
/// touch.
using FindContacts = std::function<void(const Positions& x, std::vector<ContactPlane>& planes)>;

struct StepSummary {
  int newton_iterations = 0;
  int cg_iterations = 0;
  int factorisations = 0;
  int halvings = 0;  // of a Newton correction that would have raised the potential
};

class NewtonStep {
 public:
  /// The cloth is referred to; its rest shape may change between steps.
  explicit NewtonStep(const Cloth& cloth);

  /// Moves the state by one time step.  Throws ComputationError, with the state as it was, where the system cannot be
  /// solved or a position is not finite.
  StepSummary step(State& state, const StepOptions& options, const Pins& pins, const FindContacts& find_contacts);

  IncrementalPotential& potential() { return potential_; }

 private:
  void holdPins(const Pins& pins, Positions& x);

  IncrementalPotential potential_;
  BlockMatrix hessian_;
  NewtonSystem system_;
  std::vector<char> fixed_;
  std::vector<ContactPlane> contacts_;
  Positions x_, trial_, gradient_, direction_;
};

}  // namespace ease
