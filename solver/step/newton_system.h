// Linear system of a Newton iteration, solved by conjugate gradients with an earlier factor as preconditioner.
//
//   H d = r      H: Hessian, 3n x 3n, symmetric positive definite, N/m; r: N; d: m
//
// The cloth turns little between steps, so an old factor of H is a good preconditioner. The factor leaves bending out,
// because bending couples second neighbours and would make it four times as costly. A factorisation costs as much as
// some tens of iterations. It is renewed when the last solve took more iterations than the average cost of a solve
// since the last factorisation, with that factorisation included: from then on the average rises.
#pragma once

#include <functional>
#include <limits>
#include <span>

#include "solver/linear/block_matrix.h"
#include "solver/linear/cholesky.h"

namespace ease {

/// Counts of the work in one solve.
struct SolveSummary {
  int iterations = 0;
  int factorisations = 0;
  bool ok = true;  // false: the matrix is not positive definite, or a number is not finite
};

class NewtonSystem {
 public:
  /// `ordering`: elimination order of the vertices (gradient_system.h). Each vertex is expanded to its three
  /// coordinates, which gives as little fill as ordering the 3n x 3n system and takes a fraction of the time.
  NewtonSystem(const BlockMatrix& pattern, std::span<const int> ordering);

  /// Solves H d = `right`, where H = `matrix` plus a part that has only a product: `add_product(d, product)` adds that
  /// part's product with d. Rows of `fixed` vertices stay zero. Stops when the residual, in the norm of the
  /// preconditioner, has fallen to `tolerance` times its first value, or after `max_iterations`; then, too, d lowers
  /// 1/2 d·H d - `right`·d.
  SolveSummary solve(const BlockMatrix& matrix, const std::function<void(const Positions&, Positions&)>& add_product,
                     std::span<const char> fixed, const Positions& right, double tolerance, Positions& d,
                     int max_iterations = std::numeric_limits<int>::max());

  /// Whether the last solve took few iterations, so that precondition() is close to multiplication by H^-1.
  bool factorIsNear() const;
  /// Iterations of the last solve.
  int lastIterations() const { return last_iterations_; }
  /// Applies the inverse of the factored matrix to `right`; returns the result, m. A solve() for an equal `right` that
  /// follows starts from it.
  const Positions& precondition(const Positions& right);

  /// Makes the next solve() factor anew, for example because other vertices are pinned.
  void forgetFactor() { factored_ = false; }

 private:
  bool factor(const BlockMatrix& matrix, std::span<const char> fixed);
  void precondition();

  SparseMatrix scalar_;
  Cholesky cholesky_;
  Panels panels_;
  bool factored_ = false, preconditioned_ = false;  // preconditioned_: z_ belongs to r_
  int solves_ = 0, last_iterations_ = 0;            // solves_: since the last factorisation
  double cost_ = 0.0;                               // since the last factorisation and with it, in iterations
  Positions r_, z_, p_, product_;
};

}  // namespace ease
