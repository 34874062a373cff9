// Isotropic membrane: stretches the same in every direction.
//
//   sigma_i   singular values of F, 3x2       R   nearest matrix with orthonormal columns
//
//   psi = mu |F - R|^2 + lambda/2 (sigma_1 + sigma_2 - 2)^2      mu, lambda in N/m
//
// (the co-rotational membrane).  Uniaxial: E = 4 mu (mu + lambda)/(2 mu + lambda), nu = lambda/(2 mu + lambda).
// Projective dynamics reproduces it exactly for lambda = 0, at weight 2 mu.  The polar factor is in closed form:
// C = FᵀF, d = sqrt det C, S = (C + d I)/sqrt(tr C + 2d), R = F S^-1.
#pragma once

#include "solver/energy/element.h"

namespace ease {

/// psi, N/m; adds d psi / d F, N/m, to `stress`.  Finite where F is flattened to a line or a point.
template <class Real>
Real addIsotropic(const Deformation<Real>& F, double mu, double lambda, Deformation<Real>& stress) {
  using std::sqrt;
  const Real uu = dot(F.u, F.u), uv = dot(F.u, F.v), vv = dot(F.v, F.v);
  const Real d = sqrt(larger(Real(uu * vv - uv * uv), 1e-24));  // sigma_1 sigma_2
  const Real sum = sqrt(uu + vv + 2.0 * d);                     // sigma_1 + sigma_2
  // S^-1 = adj(C + d I)/(d sum); R = F S^-1.
  const Real scale = 1.0 / (d * sum);
  const Real s_uu = scale * (vv + d), s_uv = -scale * uv, s_vv = scale * (uu + d);
  const Real tension = lambda * (sum - 2.0) - 2.0 * mu;  // on R
  addScaled(stress.u, Real(2.0 * mu + tension * s_uu), F.u);
  addScaled(stress.u, Real(tension * s_uv), F.v);
  addScaled(stress.v, Real(tension * s_uv), F.u);
  addScaled(stress.v, Real(2.0 * mu + tension * s_vv), F.v);
  // |F - R|^2 = tr C - 2 (sigma_1 + sigma_2) + 2
  return mu * (uu + vv - 2.0 * sum + 2.0) + 0.5 * lambda * (sum - 2.0) * (sum - 2.0);
}

/// Second derivative by F.
FrameHessian isotropicHessian(const Mat32& F, double mu, double lambda, HessianKind kind);

}  // namespace ease
