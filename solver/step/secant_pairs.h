// Memory of L-BFGS: the last few secant pairs, and the two-loop recursion around an initial inverse Hessian (Nocedal
// 1980).
//
//   s, y   change of position, m, and of gradient, N, over one iteration
//
// The textbook loops compute one inner product after another with a vector that changes in between. Here the loops run
// on scalars. One sweep over memory computes the products of all pairs with the unchanged vector; the products of the
// pairs with each other are stored; a second sweep applies all changes to the vector. Sums do not depend on the number
// of threads.
#pragma once

#include <array>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

class SecantPairs {
 public:
  void clear() { count_ = 0; }
  bool empty() const { return count_ == 0; }

  /// First loop of the two-loop recursion: from -gradient to q, which the caller multiplies by the initial inverse
  /// Hessian.
  void applyFirstLoop(const Positions& gradient, Positions& q);
  /// Second loop: turns that product into the search direction d.  Returns the slope, gradient . d.
  double applySecondLoop(const Positions& gradient, Positions& d);

  /// Stores the pair of two successive iterates.  A pair without positive curvature (s . y > 0) is left out.
  void remember(const Positions& x, const Positions& gradient, const Positions& next_x, const Positions& next_gradient);

 private:
  static constexpr int kMaxPairs = 5;
  using Sums = std::array<double, kMaxPairs + 2>;
  struct Pair {
    Positions s, y;
  };

  /// Index in pairs_ of the k-th newest pair.
  int slot(int k) const { return (newest_ - k + kMaxPairs) % kMaxPairs; }
  template <class Sweep>
  Sums sums(int rows, const Sweep& sweep);

  std::array<Pair, kMaxPairs> pairs_;
  std::array<std::array<double, kMaxPairs>, kMaxPairs> product_;  // s_i . y_j by slots i, j; i no newer than j
  std::array<double, kMaxPairs> alpha_;                           // alpha of the recursion, by k as in slot(k)
  int count_ = 0, newest_ = -1;
  std::vector<Sums> partial_;
};

}  // namespace ease
