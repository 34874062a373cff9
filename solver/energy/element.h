// Types and helpers that the elements share (stretch.h, shear.h, isotropic.h, bending.h, friction.h).
//
// An element's formulas are written once, as templates: Real = double computes one triangle, Real = Lanes computes
// eight triangles side by side. Such a formula has no `if` on a value. An expression of Lanes is not yet Lanes: store
// it as Real, never as auto, and write Real(...) around it where a function's parameter is a Real.
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

/// The eigenvalue as the Hessian of this kind uses it: unchanged, or zero if it is negative and `kind` is projected.
inline double keptEigenvalue(double eigenvalue, HessianKind kind) {
  return kind == HessianKind::projected && eigenvalue < 0.0 ? 0.0 : eigenvalue;
}

/// A vector in space: one column of a deformation gradient or of a stress.
template <class Real>
struct Column {
  Real x, y, z;
};

/// A 3x2 matrix by columns: a deformation gradient F = [f_u f_v], or a stress, the derivative with respect to F.
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

/// a += s b. Inlining is forced: otherwise the compiler makes calls that pass eight lanes through memory, which costs
/// 4 % of a time step.
template <class Real>
[[gnu::always_inline]] inline void addScaled(Column<Real>& a, const Real& s, const Column<Real>& b) {
  a.x += s * b.x;
  a.y += s * b.y;
  a.z += s * b.z;
}

/// A spring with energy k/2 (C - c)^2 per rest area. The condition C(F) is a number that equals c at rest, such as the
/// length of a thread (stretch.h, shear.h).
struct Spring {
  double k;  // stiffness, N/m
  double c;  // value of the condition at rest, dimensionless
};

/// Adds damping k_d/(2h) (C - C_start)^2 to an elastic spring. The sum of the two is again a spring, up to a constant,
/// and is returned. (Baraff and Witkin 1998, section 4.5, written as a potential.) `damping_over_h`: k_d/h, N/m.
/// A rigid motion leaves C unchanged, so it is not damped.
inline Spring damped(const Spring& spring, double damping_over_h, double condition_at_start) {
  const double k = spring.k + damping_over_h;
  return {k, k > 0.0 ? (spring.k * spring.c + damping_over_h * condition_at_start) / k : 0.0};
}

/// Second derivative of an energy with respect to (f_u, f_v) in 3x3 blocks, N/m. Block uv has rows of f_u and columns
/// of f_v; block vu is its transpose and is not stored.
struct FrameHessian {
  Mat3 uu = Mat3::Zero(), uv = Mat3::Zero(), vv = Mat3::Zero();

  /// Adds weight m mᵀ, where m is the 3x2 `mode` written as one vector of six entries.
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

/// The Hessian with its negative eigenvalues set to zero, by a 6x6 eigenvalue decomposition, about 2 µs. An element
/// whose eigenvalues are known by a formula uses keptEigenvalue instead.
FrameHessian projected(const FrameHessian& hessian);

}  // namespace ease
