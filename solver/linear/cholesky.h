// Sparse Cholesky factorisation P A Pᵀ = L Lᵀ, computed by CHOLMOD (Chen et al. 2008).
//
//   A   symmetric positive definite matrix, given by its lower triangle in compressed columns
//   P   ordering that keeps L sparse; computed once for a pattern and used again for all values
//
// A simplicial factor solves in double precision. A supernodal factor is faster to compute if L has many more entries
// than A, and can be copied to panels, which solve in single precision as a preconditioner (panels.h).
#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <span>
#include <vector>

#include "solver/linear/panels.h"

namespace ease {

using SparseMatrix = Eigen::SparseMatrix<double>;  // compressed columns; holds the lower triangle

class Cholesky {
 public:
  enum class Kind { kSimplicial, kSupernodal };

  explicit Cholesky(Kind kind);
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  /// Orders and analyses the pattern of `lower`. A given `ordering`, whose k-th entry is the row that is eliminated
  /// k-th, is used unchanged.
  void analyse(const SparseMatrix& lower, std::span<const int> ordering = {});

  /// Factors a matrix with the analysed pattern. Returns false, and has no factor then, if it is not positive definite.
  [[nodiscard]] bool factor(const SparseMatrix& lower);

  /// Solves A x = b for `columns` right-hand sides, each of n values, one after the other.  b and x may be the same.
  void solve(const double* b, double* x, int columns) const;

  /// Copies a supernodal factor to panels, rounded to single precision.
  void copyTo(Panels& panels) const;

  /// The ordering in use. Its k-th entry is the row that is eliminated k-th.
  std::vector<int> ordering() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// Extends an ordering of n vertices to their 3n coordinates. The three coordinates of a vertex stay together.
std::vector<int> liftOrdering(std::span<const int> ordering);

}  // namespace ease
