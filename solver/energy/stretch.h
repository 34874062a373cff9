// Stretch of a triangle along warp or weft: a spring on the length of a column of its deformation gradient.
//
//   f    column of F, 3, dimensionless; |f| = 1 where unstretched
//   k    stiffness, N/m (energies are per rest area)
//   c    length at rest; 1, or less than 1 off where damping pulls towards the length at the start of the step
//
//   psi = k/2 (|f| - c)^2      Baraff and Witkin 1998, section 4.2
#pragma once

#include "solver/mesh/triangle_gradient.h"

namespace ease {

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

/// psi, N/m.
double stretchEnergy(const Vec3& f, const Spring& spring);

/// d psi / d f, N/m.  Zero where f is.
Vec3 stretchGradient(const Vec3& f, const Spring& spring);

/// Second derivative by f, N/m, its negative part (compression, across f) set to zero.
Mat3 stretchHessian(const Vec3& f, const Spring& spring);

}  // namespace ease
