// One implicit time step of the cloth, by whichever minimiser a scene asks for.
//
//   bw1        one Newton iteration
//   newton     Newton to a residual
//   pd         a number of local/global iterations
//   pd-lbfgs   the same system as inverse Hessian of L-BFGS, to a relative error
//   auto       pd-lbfgs or Newton to a relative error, whichever takes less (method_choice.h); pd-lbfgs hands over to
//              Newton where its error falls too slowly
//
// All minimise the same incremental potential and start at x_n + h v_n.  Contacts are found there, and again where the
// cloth has ended up far from where they were found.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solver/step/method_choice.h"
#include "solver/step/newton.h"
#include "solver/step/projective.h"

namespace ease {

enum class Method { bw1, newton, pd, pd_lbfgs, automatic };

/// Names as a scene has them: bw1, newton, pd, pd-lbfgs, auto.
const std::vector<std::string>& methodNames();
const std::string& nameOf(Method method);
/// Throws std::out_of_range where there is no such method.
Method methodNamed(const std::string& name);

struct MethodOptions {
  Method method = Method::automatic;
  double tolerance = 0.05;  // relative error of a step (minimiser.h): pd-lbfgs, auto; of pd it counts the steps beyond
  double residual = 1e-2;   // newton: largest residual acceleration, m/s^2
  int iterations = 10;      // pd
};

/// Vertices held at given positions, exactly.
struct Pins {
  std::vector<int> vertices;
  std::vector<Vec3> positions;  // at the end of the step, m
};

/// Fills a plane for each sample of the cloth (contact.h) at these positions; leaves the vector empty where nothing can
/// touch.
using FindContacts = std::function<void(const Positions& x, Contacts& contacts)>;

/// What a time step, or several, took.
struct StepSummary {
  long newton_iterations = 0;
  long projective_iterations = 0;
  long cg_iterations = 0;
  long factorisations = 0;
  long halvings = 0;        // of corrections that would have raised the potential
  long contact_rounds = 0;  // how often contacts were found
  long handed_over = 0;     // time steps in which `auto` went from pd-lbfgs to Newton
  long short_of_tolerance =
      0;  // time steps that ended before the tolerance was met, by round-off or the iteration limit

  bool converged() const { return short_of_tolerance == 0; }
  StepSummary& operator+=(const StepSummary& other);
};

class TimeStep {
 public:
  /// The cloth is referred to; its rest shape may change between steps.  `ordering`: of the mesh's systems
  /// (gradient_system.h).
  TimeStep(const Cloth& cloth, const MethodOptions& options, std::span<const int> ordering);

  /// Moves the state by one time step.  Throws ComputationError, with the state as it was, where a system cannot be
  /// solved.
  StepSummary step(State& state, const StepOptions& options, const Pins& pins, const FindContacts& find_contacts);

  /// Makes the next step depend on its state alone, not on factors and directions kept from earlier ones.
  void forget();

  IncrementalPotential& potential() { return potential_; }

 private:
  void holdPins(const Pins& pins, Positions& x);
  void liftOut(Positions& x) const;
  void minimise(StepSummary& summary);
  void newton(const StopRule& stop, StepSummary& summary);
  void projective(const StopRule& stop, bool accelerated, StepSummary& summary);

  MethodOptions options_;
  IncrementalPotential potential_;
  std::optional<Newton> newton_;
  std::optional<Projective> projective_;
  MethodChoice choice_;  // auto
  std::vector<char> fixed_;
  Contacts contacts_;
  Positions found_at_;
  Point point_;
};

}  // namespace ease
