// Isotropic membrane: equally stiff in every direction.
//
//   sigma_i   singular values of F, 3x2       R   nearest matrix with orthonormal columns
//
//   psi = mu |F - R|^2 + lambda/2 (sigma_1 + sigma_2 - 2)^2      mu, lambda in N/m
//
// This is the co-rotational membrane. Pulled in one direction, it has Young's modulus
// E = 4 mu (mu + lambda)/(2 mu + lambda), N/m, and Poisson's ratio nu = lambda/(2 mu + lambda).
// For lambda = 0, projective dynamics reproduces it exactly, at weight 2 mu. The polar decomposition F = R S is
// computed in closed form:
//
//   C = FᵀF,  d = sqrt det C,  S = (C + d I)/sqrt(tr C + 2d),  R = F S^-1
#pragma once

#include "solver/energy/element.h"

namespace ease {

/// Returns psi, N/m, and adds d psi / d F, N/m, to `stress`. Both are finite even where F flattens the triangle to a
/// line or a point.
template <class Real>
Real addIsotropic(const Deformation<Real>& F, double mu, double lambda, Deformation<Real>& stress) {
  using std::sqrt;
  const Real uu = dot(F.u, F.u), uv = dot(F.u, F.v), vv = dot(F.v, F.v);
  const Real d = sqrt(larger(Real(uu * vv - uv * uv), 1e-24));  // sigma_1 sigma_2
  const Real sum = sqrt(uu + vv + 2.0 * d);                     // sigma_1 + sigma_2
  // S^-1 = adj(C + d I)/(d sum), with adj the adjugate; then R = F S^-1.
  const Real scale = 1.0 / (d * sum);
  const Real s_uu = scale * (vv + d), s_uv = -scale * uv, s_vv = scale * (uu + d);
  const Real tension = lambda * (sum - 2.0) - 2.0 * mu;  // factor of R in the stress
  addScaled(stress.u, Real(2.0 * mu + tension * s_uu), F.u);
  addScaled(stress.u, Real(tension * s_uv), F.v);
  addScaled(stress.v, Real(tension * s_uv), F.u);
  addScaled(stress.v, Real(2.0 * mu + tension * s_vv), F.v);
  // |F - R|^2 = tr C - 2 (sigma_1 + sigma_2) + 2
  return mu * (uu + vv - 2.0 * sum + 2.0) + 0.5 * lambda * (sum - 2.0) * (sum - 2.0);
}

/// Second derivative of psi with respect to F, N/m.
FrameHessian isotropicHessian(const Mat32& F, double mu, double lambda, HessianKind kind);

}  // namespace ease
