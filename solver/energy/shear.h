// Shear of a triangle, in one of two forms.
//
//   F = [f_u f_v]              3x2 deformation gradient
//   d+- = (f_u +- f_v)/sqrt 2  bias directions
//
//   orthogonal   C = |d+| - |d-|   the difference of the two bias stretches
//   bw98         C = f_u . f_v     Baraff and Witkin 1998, per area
//   psi = k/2 (C - c)^2            k in N/m; c as in stretch.h
//
// Both are zero exactly where f_u is orthogonal to f_v, and agree to second order near F's rest.  With c = 0 the first
// is k times the squared distance of F to the nearest pair of orthogonal columns, so that projective dynamics
// reproduces it exactly, at weight 2k.
#pragma once

#include "solver/energy/element.h"

namespace ease {

/// C, dimensionless.
double orthogonalShear(const Mat32& F);
inline double bw98Shear(const Mat32& F) {
  return F.col(0).dot(F.col(1));
}

/// psi, N/m; adds d psi / d F, N/m, to `stress`.
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

template <class Real>
Real addBw98Shear(const Deformation<Real>& F, double k, const Real& c, Deformation<Real>& stress) {
  const Real excess = dot(F.u, F.v) - c;
  addScaled(stress.u, Real(k * excess), F.v);
  addScaled(stress.v, Real(k * excess), F.u);
  return 0.5 * k * excess * excess;
}

/// Second derivative by F.
FrameHessian orthogonalShearHessian(const Mat32& F, const Spring& spring, HessianKind kind);
FrameHessian bw98ShearHessian(const Mat32& F, const Spring& spring, HessianKind kind);

}  // namespace ease
