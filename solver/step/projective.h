// Projective dynamics: alternating local projections and one constant linear system (Bouaziz et al. 2014), and the same
// system as the initial inverse Hessian of L-BFGS (Liu et al. 2017).
//
//   local    p_t      nearest point of each term's set to F_t, in closed form
//   global   A x = M y / h^2 + sum_t a_t B_t p_t W,     A = M/h^2 + sum_t a_t B_t W B_tᵀ
//
// Since k (F - p) is a term's stress, one such iteration is the correction x - A^-1 dE/dx.  That is how it is computed:
// from the gradient, which all terms have, whether A knows them or not.  For terms that are distances to a set A is the
// exact bound and each iteration lowers E.  `pd` takes the correction as it is; `pd-lbfgs` improves it by the secant
// pairs of the last iterations and searches along it.
//
// A is factored once and again when the rest shape, the time step, damping or the pins change, and when the stiffness
// of contact has drifted away from what A has on its diagonal.  Plain pd needs an upper bound of the contact stiffness,
// or it diverges: A then counts every sample as pressed.  pd-lbfgs converges with 0.3 of the present stiffness.
//
// Tried: L-BFGS on a factor of Newton's matrix instead.  On the scanned shirt of 4,271 vertices it takes 2 to 5
// iterations for 11 while the factor is of the same step, which costs more than they save; a step later 9 to 14, with
// halvings: cloth that was compressed then is soft in it.
#pragma once

#include <vector>

#include "solver/linear/gradient_system.h"
#include "solver/step/minimiser.h"
#include "solver/step/secant_pairs.h"

namespace ease {

class Projective {
 public:
  /// `ordering`: of the mesh's systems (gradient_system.h).
  Projective(const Cloth& cloth, std::span<const int> ordering);

  /// Iterates from `point`, which must be evaluated, and leaves it evaluated.  `accelerated`: pd-lbfgs instead of pd.
  MinimiserSummary minimise(IncrementalPotential& potential, const std::vector<char>& fixed, const StopRule& stop,
                            bool accelerated, Point& point);

  /// Makes the next minimise() independent of earlier ones.
  void forget() {
    rest_revision_ = -1;
    pairs_.clear();
  }

 private:
  bool prepare(IncrementalPotential& potential, const std::vector<char>& fixed, bool accelerated, const Positions& x);
  double solveForDirection(const IncrementalPotential& potential, const Point& point);

  GradientSystem system_;
  // Inputs of the current factor, compared to decide whether it can be used again.
  int rest_revision_ = -1;
  double h_ = 0.0;
  bool accelerated_ = false;
  Eigen::Vector2d weights_ = Eigen::Vector2d::Zero();
  std::vector<char> fixed_;
  std::vector<double> contact_;  // N/m, on A's diagonal

  std::vector<double> contact_now_, diagonal_;
  std::vector<Mat2> scaled_inverse_;
  SecantPairs pairs_;
  Positions direction_;
  Point next_;
  std::vector<double> decrements_;  // relative decrements of the current minimise(), one per iteration
};

}  // namespace ease
