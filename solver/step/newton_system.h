// The linear system of a Newton step, solved by conjugate gradients on an earlier step's factor.
//
//   H d = r      H: projected Hessian, 3n x 3n, symmetric positive definite, N/m; r: N; d: m
//
// The cloth turns little between steps, so that an old factor of H (without bending, whose second ring would make it
// four times as costly) is a good preconditioner.  A factor costs as much as some tens of iterations: it is renewed
// when an iteration count exceeds the average cost of a solve since the last factor, the factor included, which is when
// the average begins to rise.
#pragma once

#include <functional>
#include <span>

#include "solver/linear/block_matrix.h"
#include "solver/linear/cholesky.h"

namespace ease {

struct SolveSummary {
  int iterations = 0;
  int factorisations = 0;
  bool ok = true;  // false: not positive definite, or NaN
};

class NewtonSystem {
 public:
  /// `ordering`: of the mesh's systems (gradient_system.h), lifted here by blocks of 3 x 3: the same fill as ordering
  /// the 3n x 3n system, in a fraction of the time.
  NewtonSystem(const BlockMatrix& pattern, std::span<const int> ordering);

  /// `add_product(d, product)` adds what H has beyond `matrix`.  Rows of `fixed` vertices stay zero.  Stops when the
  /// residual, measured by the preconditioner, is `tolerance` of what it was.
  SolveSummary solve(const BlockMatrix& matrix, const std::function<void(const Positions&, Positions&)>& add_product,
                     std::span<const char> fixed, const Positions& right, double tolerance, Positions& d);

  /// Whether the last solve took few iterations, so that precondition() comes close to H^-1.
  bool factorIsNear() const;
  /// Of the last solve.
  int lastIterations() const { return last_iterations_; }
  /// What the factor makes of `right` by itself, m.  A solve() for the same `right` that follows begins with it.
  const Positions& precondition(const Positions& right);

  /// The factor no longer serves (other pins).
  void forgetFactor() { factored_ = false; }

 private:
  bool factor(const BlockMatrix& matrix, std::span<const char> fixed);
  void precondition();

  SparseMatrix scalar_;
  Cholesky cholesky_;
  Panels panels_;
  bool factored_ = false, preconditioned_ = false;  // z_ is of r_, by the factor
  int solves_ = 0, last_iterations_ = 0;            // since the last factor
  double cost_ = 0.0;                               // in iterations, the factor included
  Positions r_, z_, p_, product_;
};

}  // namespace ease
