// Shear of a triangle, in one of two forms.
//
//   F = [f_u f_v]              3x2 deformation gradient
//   d+- = (f_u +- f_v)/sqrt 2  bias directions
//
//   orthogonal   C = |d+| - |d-|   the difference of the two bias stretches
//   bw98         C = f_u . f_v     Baraff and Witkin 1998, per area
//   psi = k/2 (C - c)^2            k stiffness, N/m; c value of C at rest: 0 without damping, shifted by damping
//                                  towards C at the start of the step
//
// In both forms C is zero exactly where f_u is orthogonal to f_v, and the two agree to second order near the rest
// shape. With c = 0, psi of the orthogonal form is k times the squared distance of F to the nearest matrix with
// orthogonal columns. Projective dynamics therefore reproduces it exactly, at weight 2k.
#pragma once

#include "solver/energy/element.h"

namespace ease {

/// Condition C of the orthogonal form, dimensionless.
double orthogonalShear(const Mat32& F);
/// Condition C of the form bw98, dimensionless.
inline double bw98Shear(const Mat32& F) {
  return F.col(0).dot(F.col(1));
}

/// Returns psi of the orthogonal form, N/m, and adds d psi / d F, N/m, to `stress`.
template <class Real>
Real addOrthogonalShear(const Deformation<Real>& F, double k, const Real& c, Deformation<Real>& stress) {
  const Column<Real> plus{F.u.x + F.v.x, F.u.y + F.v.y, F.u.z + F.v.z};
  const Column<Real> minus{F.u.x - F.v.x, F.u.y - F.v.y, F.u.z - F.v.z};
  const Real plus_length = length(plus), minus_length = length(minus);
  const Real excess = M_SQRT1_2 * (plus_length - minus_length) - c;
  const Real along_plus = M_SQRT1_2 * k * excess / larger(plus_length, 1e-150);
  const Real along_minus = -M_SQRT1_2 * k * excess / larger(minus_length, 1e-150);
  addScaled(stress.u, along_plus, plus);
  addScaled(stress.u, along_minus, minus);
  addScaled(stress.v, along_plus, plus);
  addScaled(stress.v, Real(-along_minus), minus);
  return 0.5 * k * excess * excess;
}

/// Returns psi of the form bw98, N/m, and adds d psi / d F, N/m, to `stress`.
template <class Real>
Real addBw98Shear(const Deformation<Real>& F, double k, const Real& c, Deformation<Real>& stress) {
  const Real excess = dot(F.u, F.v) - c;
  addScaled(stress.u, Real(k * excess), F.v);
  addScaled(stress.v, Real(k * excess), F.u);
  return 0.5 * k * excess * excess;
}

/// Second derivative of psi with respect to F, N/m, in either form.
FrameHessian orthogonalShearHessian(const Mat32& F, const Spring& spring, HessianKind kind);
FrameHessian bw98ShearHessian(const Mat32& F, const Spring& spring, HessianKind kind);

}  // namespace ease
