// Stretch of a triangle along warp or weft: a spring on the length of a column of its deformation gradient.
//
//   f    column of F, 3, dimensionless; |f| = 1 where unstretched
//   k    stiffness, N/m (energies are per rest area)
//   c    rest length: 1 without damping; damping shifts it towards |f| at the start of the step
//
//   psi = k/2 (|f| - c)^2      Baraff and Witkin 1998, section 4.2
//
// Projective dynamics reproduces this energy exactly, at weight k: the nearest vector with psi = 0 is c f / |f|.
#pragma once

#include "solver/energy/element.h"

namespace ease {

/// Returns psi, N/m, and adds d psi / d f, N/m, to `stress`. Adds nothing where f is zero.
template <class Real>
Real addStretch(const Column<Real>& f, double k, const Real& c, Column<Real>& stress) {
  const Real now = length(f);
  const Real excess = now - c;
  const Real tension = k * excess / larger(now, 1e-150);
  addScaled(stress, tension, f);
  return 0.5 * k * excess * excess;
}

/// Second derivative of psi with respect to f, N/m. Under compression (|f| < c) it is negative perpendicular to f.
Mat3 stretchHessian(const Vec3& f, const Spring& spring, HessianKind kind);

}  // namespace ease
