// Projective dynamics, accelerated in the two ways that others do it: curves of the bench alone.
//
//   G(x)        x - A^-1 dE/dx: one iteration of `pd` (projective.h)        F(x)   G(x) - x
//   anderson    x_k+1 = G_k - sum_j theta_j (G_j+1 - G_j), where theta makes |F_k - sum_j theta_j (F_j+1 - F_j)| least
//               over the last five differences; where that has raised E, the next step starts from the last G (Peng et
//               al. 2018, Anderson acceleration for geometry optimization and physics simulation)
//   chebyshev   x_k+1 = w_k+1 (G_k - x_k-1) + x_k-1,  w = 1 at first, then 2/(2 - rho^2), then 4/(4 - rho^2 w_k) (Wang
//               2015, A Chebyshev semi-iterative approach for accelerating projective and position-based dynamics)
//
// rho, the rate at which plain iterations converge in the end, is measured once, in the first step.  For cloth that
// touches nothing; A has mass, membrane and bending's bound, as in projective.h.
#pragma once

#include <span>
#include <vector>

#include "solver/linear/gradient_system.h"
#include "solver/step/time_step.h"

namespace ease {

enum class Acceleration { anderson, chebyshev };

class AcceleratedPd {
 public:
  /// Arguments as of TimeStep, and the number of iterations in each step.
  AcceleratedPd(const Cloth& cloth, Acceleration acceleration, int iterations, std::span<const int> ordering);

  /// Takes one step, as TimeStep::step() does.  Throws ComputationError where there is a contact, too.
  StepSummary step(State& state, const StepOptions& options, const Pins& pins, const FindContacts& find_contacts);

 private:
  void factor(double h);
  /// Computes F at the point, whose gradient must be up to date.
  void findCorrection();
  void measureRate();
  void anderson();
  void chebyshev();

  Acceleration acceleration_;
  int iterations_;
  IncrementalPotential potential_;
  GradientSystem system_;
  std::vector<char> fixed_;
  bool prepared_ = false;
  double rate_ = 0.0;  // rho
  Point point_;
  Positions correction_;  // F
};

}  // namespace ease
