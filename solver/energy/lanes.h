// Arithmetic on one triangle or on eight side by side: the same formulas, written once for Real = double or Lanes.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace ease {

constexpr int kLanes = 8;
using Lanes = Eigen::Array<double, kLanes, 1>;

inline double larger(double a, double b) {
  return std::max(a, b);
}
inline Lanes larger(const Lanes& a, double b) {
  return a.max(b);
}

/// Whether an element's Hessian keeps its negative eigenvalues (exact) or has them set to zero (projected).
enum class HessianKind { exact, projected };

inline double keptEigenvalue(double eigenvalue, HessianKind kind) {
  return kind == HessianKind::projected && eigenvalue < 0.0 ? 0.0 : eigenvalue;
}

/// A vector in space: a column of a deformation gradient, or of its stress.
template <class Real>
struct Column {
  Real x, y, z;
};

/// Deformation gradient [f_u f_v], 3x2, or what belongs to its entries.
template <class Real>
struct Deformation {
  Column<Real> u, v;
};

template <class Real>
Real dot(const Column<Real>& a, const Column<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
Real length(const Column<Real>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// a += s b.  Left to itself, the compiler calls it, with eight lanes in memory: 4 % of a time step.
template <class Real>
[[gnu::always_inline]] inline void addScaled(Column<Real>& a, const Real& s, const Column<Real>& b) {
  a.x += s * b.x;
  a.y += s * b.y;
  a.z += s * b.z;
}

}  // namespace ease
