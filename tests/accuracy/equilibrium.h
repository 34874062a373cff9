// Equilibria of a piece of cloth under gravity or given loads, by any method, and the forces that hold it.
#pragma once

#include <functional>

#include "solver/step/time_step.h"

namespace ease {

inline const FindContacts kNoContacts = [](const Positions&, Contacts& contacts) { contacts.planes.clear(); };

inline State atRest(const Positions& positions) {
  return {positions, Positions::Zero(positions.rows(), 3)};
}

/// Stops at round-off, or nearly.
inline MethodOptions tight(Method method) {
  return {method, 1e-9, 1e-9, 3000};
}

inline TimeStep makeStep(const Cloth& cloth, const MethodOptions& options) {
  return TimeStep(cloth, options, systemOrdering(cloth.vertexCount(), cloth.triangles()));
}

/// Holds every vertex that `held` says where it is in x.
inline Pins pinsWhere(const Positions& x, const std::function<bool(int)>& held) {
  Pins pins;
  for (int i = 0; i < x.rows(); ++i)
    if (held(i)) {
      pins.vertices.push_back(i);
      pins.positions.push_back(x.row(i));
    }
  return pins;
}

inline std::vector<char> onBoundary(const Cloth& cloth) {
  std::vector<char> boundary(cloth.vertexCount(), 0);
  for (const std::vector<int>& loop : cloth.topology().boundary_loops)
    for (int v : loop) boundary[v] = 1;
  return boundary;
}

/// Force on every vertex besides gravity at positions x, n x 3, N.
using Load = std::function<Positions(const Positions& x)>;

/// What holds and loads a cloth that is to come to rest, and when it has.
struct Settling {
  StepOptions options;
  Pins pins;
  double still = 1e-8;  // m: at rest where no vertex moves by more in a step
  int most_steps = 100;
  Load load = {};
  FindContacts contacts = kNoContacts;
};

/// Takes steps, each of which starts without velocity, until the cloth is at rest; returns whether it got there.  A
/// load enters as the velocity that gives the step the same impulse.
inline bool settle(TimeStep& step, State& state, const Settling& settling) {
  const double h = settling.options.h;
  const std::vector<double>& masses = step.potential().cloth().masses();
  for (int n = 0; n < settling.most_steps; ++n) {
    const Positions before = state.positions;
    state.velocities.setZero();
    if (settling.load) {
      state.velocities = h * settling.load(before);
      for (int i = 0; i < before.rows(); ++i) state.velocities.row(i) /= masses[i];
    }
    step.step(state, settling.options, settling.pins, settling.contacts);
    if ((state.positions - before).rowwise().norm().maxCoeff() <= settling.still) return true;
  }
  return false;
}

/// Force with which the cloth at rest at x pulls at each vertex, n x 3, N: minus the gradient of its elastic energy.
inline Positions internalForces(const Cloth& cloth, const Positions& x) {
  IncrementalPotential potential(cloth);
  StepOptions options;
  options.gravity.setZero();
  potential.begin(atRest(x), options);
  Positions gradient(x.rows(), 3);
  potential.gradient(x, gradient);
  return -gradient;
}

}  // namespace ease
