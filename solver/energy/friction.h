// Friction between one sample of the cloth and the body, as a smooth potential of the sample's slip in this step.
//
//   D = mu lambda f0(y),   J       y = |u|
//
//   u        slip: tangential displacement of the sample over the step less that of the body's surface, m
//   mu       coefficient of friction
//   lambda   normal force on the sample, N, taken from the last minimisation and constant in this one ("lagged")
//   e        slip length, m: the slip below which the sample counts as sticking; slip speed times time step
//
//            y < e               y >= e
//   f0       y²/e - y³/(3e²)     y - e/3      m; f0' = f1, continuously differentiable
//   f1       2y/e - y²/e²        1            the share of Coulomb's force mu lambda that acts
//   f1/y     2/e - y/e²          1/y          weight, 1/m: the force is mu lambda (f1/y) u against the slip
//
// After Li et al., Incremental Potential Contact, ACM Transactions on Graphics 39(4), 2020, section 5 (their f0 is
// larger by the constant e/3). D is convex in u. It is concave in y²; therefore the quadratic mu lambda (f1/y) y'²/2
// with the weight f1/y at any slip y bounds D from above up to a constant, and touches it at y' = y.
#pragma once

#include <algorithm>

#include "solver/energy/element.h"

namespace ease {

inline double smaller(double a, double b) {
  return std::min(a, b);
}
inline Lanes smaller(const Lanes& a, double b) {
  return a.min(b);
}

/// f0, m. Real is double for one sample, or Lanes (element.h) for eight side by side.
template <class Real>
Real frictionPotential(const Real& y, double e) {
  const Real r = smaller(Real(y / e), 1.0);
  return e * r * r * (1.0 - r / 3.0) + larger(Real(y - e), 0.0);
}

/// f1/y, 1/m: 2/e without slip, and less the further the sample slips.
template <class Real>
Real frictionWeight(const Real& y, double e) {
  const Real r = smaller(Real(y / e), 1.0);
  return (2.0 - r) / larger(y, e);
}

/// Second derivative of f0(|u|) with respect to the sample's position, 1/m; `normal` is the plane's, unit, and u is
/// tangential. Positive semi-definite. `projected` gives the bound f1/y in all tangential directions instead.
inline Mat3 frictionHessian(const Vec3& u, const Vec3& normal, double e, HessianKind kind) {
  const double y = u.norm(), weight = frictionWeight(y, e);
  Mat3 hessian = weight * (Mat3::Identity() - normal * normal.transpose());
  if (kind == HessianKind::exact && y > 0.0) {
    const double along = 2.0 * (1.0 - std::min(y / e, 1.0)) / e;  // derivative of f1
    hessian += (along - weight) / (y * y) * u * u.transpose();
  }
  return hessian;
}

}  // namespace ease
