// Sparse Cholesky factorisation P A Pᵀ = L Lᵀ over CHOLMOD (Chen et al. 2008).
//
//   A   symmetric positive definite, given by its lower triangle, compressed columns
//   P   ordering that keeps L sparse: found once for a pattern, reused for every set of values
//
// A simplicial factor is kept and solved with here, in double precision.  A supernodal one is factored faster where
// fill is large, and can be handed on as panels, with which a preconditioner is solved (panels.h).
#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <span>
#include <vector>

#include "solver/linear/panels.h"

namespace ease {

using SparseMatrix = Eigen::SparseMatrix<double>;  // compressed columns; ours hold the lower triangle

class Cholesky {
 public:
  enum class Kind { kSimplicial, kSupernodal };

  explicit Cholesky(Kind kind);
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  /// Orders and analyses the pattern of `lower`.  An `ordering` (k-th entry: the row that comes k-th) is used as it is.
  void analyse(const SparseMatrix& lower, std::span<const int> ordering = {});

  /// Factors values on the analysed pattern.  Returns false, without a factor, if A is not positive definite.
  [[nodiscard]] bool factor(const SparseMatrix& lower);
  bool isFactored() const;

  /// Solves A x = b for `columns` right-hand sides, each of n values, one after the other.  b and x may be the same.
  void solve(const double* b, double* x, int columns) const;

  /// Copies a supernodal factor to panels, rounded to single precision.
  void copyTo(Panels& panels) const;

  /// The ordering in use; its k-th entry is the row that comes k-th.
  std::vector<int> ordering() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// Extends an ordering of n vertices to their 3n coordinates; those of a vertex stay together.
std::vector<int> liftOrdering(std::span<const int> ordering);

}  // namespace ease
