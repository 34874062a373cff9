// Projective dynamics with two accelerations from the literature.  Only the benchmarks use them, for comparison.
//
//   G(x)        x - A^-1 dE/dx: one iteration of `pd` (projective.h)        F(x)   G(x) - x
//   anderson    x_k+1 = G_k - sum_j theta_j (G_j+1 - G_j), where theta minimises |F_k - sum_j theta_j (F_j+1 - F_j)|
//               over the last five differences; if this has increased E, the next iteration starts from the last G
//               (Peng et al. 2018, Anderson acceleration for geometry optimization and physics simulation)
//   chebyshev   x_k+1 = w_k+1 (G_k - x_k-1) + x_k-1,  w = 1 at first, then 2/(2 - rho^2), then 4/(4 - rho^2 w_k) (Wang
//               2015, A Chebyshev semi-iterative approach for accelerating projective and position-based dynamics)
//
// rho, the asymptotic convergence rate of plain iterations, is measured once, in the first step.  The methods are for
// cloth without contact.  The matrix A consists of mass, membrane and an upper bound of bending, as in projective.h.
#pragma once

#include <span>
#include <vector>

#include "solver/linear/gradient_system.h"
#include "solver/step/time_step.h"

namespace ease {

enum class Acceleration { anderson, chebyshev };

class AcceleratedPd {
 public:
  /// Takes the arguments of TimeStep, the acceleration and the number of iterations in each step.
  AcceleratedPd(const Cloth& cloth, Acceleration acceleration, int iterations, std::span<const int> ordering);

  /// Takes one step like TimeStep::step().  Also throws ComputationError if there is a contact.
  StepSummary step(State& state, const StepOptions& options, const Pins& pins, const FindContacts& find_contacts);

 private:
  void factor(double h);
  /// Computes F at the current point, whose gradient must be up to date.
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
