// What the elements of the membrane share (stretch.h, shear.h, isotropic.h).
//
// Their formulas are written once for Real = double, one triangle, or Real = Lanes, eight triangles side by side.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "solver/mesh/triangle_gradient.h"

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

/// A spring: its stiffness and the value of its condition at rest.
struct Spring {
  double k;
  double c;
};

/// Elastic spring (k, c) with condition-rate damping over a step: k_d/(2h) (C - C_start)^2 added, up to a constant
/// (Baraff and Witkin 1998, section 4.5, as a potential).  Forceless on rigid motion, since C is.
inline Spring damped(const Spring& spring, double damping_over_h, double condition_at_start) {
  const double k = spring.k + damping_over_h;
  return {k, k > 0.0 ? (spring.k * spring.c + damping_over_h * condition_at_start) / k : 0.0};
}

/// Blocks of the second derivative by (f_u, f_v), each 3x3, N/m: uu, uv (row f_u, column f_v), vv.
struct FrameHessian {
  Mat3 uu = Mat3::Zero(), uv = Mat3::Zero(), vv = Mat3::Zero();

  /// Adds `weight` times the square of a mode, 3x2.
  void addMode(double weight, const Mat32& mode) {
    uu += weight * mode.col(0) * mode.col(0).transpose();
    uv += weight * mode.col(0) * mode.col(1).transpose();
    vv += weight * mode.col(1) * mode.col(1).transpose();
  }
  FrameHessian& operator+=(const FrameHessian& other) {
    uu += other.uu, uv += other.uv, vv += other.vv;
    return *this;
  }
  FrameHessian& operator*=(double factor) {
    uu *= factor, uv *= factor, vv *= factor;
    return *this;
  }
};

}  // namespace ease
