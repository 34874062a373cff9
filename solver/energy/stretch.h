// Stretch of a triangle along warp or weft: a spring on the length of a column of its deformation gradient.
//
//   f    column of F, 3, dimensionless; |f| = 1 where unstretched
//   k    stiffness, N/m (energies are per rest area)
//   c    rest length: 1 without damping; damping shifts it towards |f| at the start of the step
//
//   s    softening, N/m, 0 to k: stiffness that the thread lacks where it is compressed
//
//   psi = k/2 (|f| - c)^2 - s/2 max(0, 1 - |f|)^2      Baraff and Witkin 1998, section 4.2, where s = 0
//
// Cloth under compression wrinkles. Wrinkles finer than a triangle cannot be represented by it; soft compression stands
// in for them (tension field theory, Pipkin 1986). Without it the triangle shears and stretches instead.
//
// Projective dynamics reproduces this energy exactly for s = 0, at weight k: the nearest vector with psi = 0 is
// c f / |f|. With softening, k is an upper bound.
#pragma once

#include "solver/energy/element.h"

namespace ease {

/// Returns psi, N/m, and adds d psi / d f, N/m, to `stress`. Adds nothing where f is zero.
template <class Real>
Real addStretch(const Column<Real>& f, double k, const Real& c, Column<Real>& stress, double softening = 0.0) {
  const Real now = length(f);
  const Real excess = now - c;
  const Real slack = larger(Real(1.0 - now), 0.0);
  const Real tension = (k * excess + softening * slack) / larger(now, 1e-150);
  addScaled(stress, tension, f);
  return 0.5 * (k * excess * excess - softening * slack * slack);
}

/// Second derivative of psi with respect to f, N/m. Under compression (|f| < c) it is negative perpendicular to f.
Mat3 stretchHessian(const Vec3& f, const Spring& spring, HessianKind kind, double softening = 0.0);

}  // namespace ease
