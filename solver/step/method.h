// The methods that a scene chooses from for its time steps (time_step.h), and what they count.
#pragma once

#include <string>
#include <vector>

namespace ease {

enum class Method { bw1, newton, pd, pd_lbfgs, automatic };

/// Names of the methods in scene files: bw1, newton, pd, pd-lbfgs, auto.
const std::vector<std::string>& methodNames();
const std::string& nameOf(Method method);
/// Throws std::out_of_range if no method has this name.
Method methodNamed(const std::string& name);

struct MethodOptions {
  Method method = Method::automatic;
  // Largest relative error of a step (minimiser.h). pd-lbfgs and auto stop there; for bw1 and pd, steps with a larger
  // error are only counted (StepSummary::short_of_tolerance).
  double tolerance = 0.05;
  double residual = 1e-2;  // newton: largest residual acceleration, m/s^2
  int iterations = 10;     // pd: number of iterations
};

/// Counts of the work in one time step, or summed over several.
struct StepSummary {
  long newton_iterations = 0;
  long projective_iterations = 0;
  long cg_iterations = 0;
  long factorisations = 0;
  long halvings = 0;        // number of times a correction was halved because it did not lower the potential enough
  long contact_rounds = 0;  // number of times contacts were found
  long kept_planes = 0;     // contact planes that samples kept from earlier rounds of a step (time_step.h)
  long handed_over = 0;     // time steps in which `auto` handed over from pd-lbfgs to Newton
  // Time steps that ended before the tolerance was met, because of round-off or the limit on iterations.
  long short_of_tolerance = 0;

  bool converged() const { return short_of_tolerance == 0; }
  StepSummary& operator+=(const StepSummary& other);
};

}  // namespace ease
