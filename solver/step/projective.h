// Projective dynamics. `pd` alternates local projections with one constant linear system (Bouaziz et al. 2014);
// `pd-lbfgs` uses that system as the initial inverse Hessian of L-BFGS (Liu et al. 2017).
//
//   local    p_t = the point nearest to F_t in the set where the element's energy is zero, in closed form
//   global   A x = M y / h^2 + sum_t a_t B_t W p_tᵀ,    A = M/h^2 + sum_t a_t B_t W B_tᵀ
//            A's diagonal also has contact's stiffness and, for `pd`, a bound of bending
//
//   F_t    deformation gradient of triangle t, xᵀ B_t         M, y, h, a_t   as in incremental_potential.h
//   W      diagonal matrix of the weights along warp and weft, N/m (MembraneEnergy::projectiveWeights)
//
// An element with energy k/2 |F - p|^2 has the stress k (F - p), so one iteration is the correction x - A^-1 dE/dx. It
// is computed in this form, because every energy has a gradient, even if it has no part in A. For energies that are
// squared distances to a set, A is an upper bound of the Hessian and each iteration lowers E. `pd` takes the correction
// as it is, halved only where E would rise; `pd-lbfgs` first improves it with the secant pairs of the last iterations.
//
// A is factored again when the rest shape, the time step, damping or the pins change, and when the contact stiffness
// has drifted away from the stiffness on A's diagonal: by half, or by a fifth where iterations have become more. `pd`
// needs an upper bound of the contact stiffness, so A counts every sample as pressed. `pd-lbfgs` takes half of the
// present stiffness, and softer threads where they are compressed when A is factored
// (MembraneEnergy::projectiveWeightsAt): the secant pairs learn the rest. Friction counts as contact stiffness, as
// stiff as it is without slip: with the stiffness at the present slip, pd-lbfgs halves nearly every correction where
// cloth begins to stick, and takes 1.6 times as many iterations on scenes/t-shirt.toml.
//
// Tried and dropped: L-BFGS with a factor of Newton's matrix in place of A. On a scanned shirt of 4,271 vertices it
// takes 2 to 5 iterations instead of 11 if the matrix is factored in the same step, but that costs more than it saves.
// With the factor of the step before it takes 9 to 14 iterations, with halvings, because the factor is too soft where
// cloth was compressed.
#pragma once

#include <vector>

#include "solver/linear/gradient_system.h"
#include "solver/step/minimiser.h"
#include "solver/step/secant_pairs.h"

namespace ease {

class Projective {
 public:
  /// `ordering`: elimination order of the vertices (gradient_system.h).
  Projective(const Cloth& cloth, std::span<const int> ordering);

  /// Iterates from `point`, which must be evaluated, and leaves it evaluated.  `accelerated`: pd-lbfgs instead of pd.
  /// Throws ComputationError if A is not positive definite.
  MinimiserSummary minimise(IncrementalPotential& potential, const std::vector<char>& fixed, const StopRule& stop,
                            bool accelerated, Point& point);

  /// Makes the next minimise() independent of earlier ones.
  void forget() {
    rest_revision_ = -1;
    pairs_.clear();
  }

 private:
  /// Factors A if its inputs have changed; returns whether it did.
  bool prepare(IncrementalPotential& potential, const std::vector<char>& fixed, bool accelerated, const Positions& x);
  double solveForDirection(const IncrementalPotential& potential, const Point& point);

  GradientSystem system_;
  // Inputs of the current factor, compared to decide whether it can be used again.
  int rest_revision_ = -1;
  double h_ = 0.0;
  bool accelerated_ = false;
  Eigen::Vector2d weights_ = Eigen::Vector2d::Zero();
  std::vector<char> fixed_;
  std::vector<double> contact_;  // contact stiffness per vertex, N/m

  int solves_ = 0, iterations_ = 0, last_iterations_ = 0;  // since A was factored
  std::vector<double> contact_now_, diagonal_;
  std::vector<Mat2> scaled_inverse_;
  SecantPairs pairs_;
  Positions direction_;
  Point next_;
  std::vector<double> decrements_;  // relative decrements of the current minimise(), one per iteration
};

}  // namespace ease
