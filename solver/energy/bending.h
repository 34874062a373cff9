// Bending of a hinge: quadratic in positions, flat at rest (Bergou et al. 2006; Wardetzky et al. 2007).
//
//   b = sum_i K_i x_i   hinge vector, 3, dimensionless; zero where the four vertices lie in a plane (hinge.h)
//   w = D / (A0 + A1)   D bending stiffness, N m; A0, A1 rest areas beside the edge
//   energy  w/2 |b|^2,  J
//
// Their form 1/2 3/(A0+A1) |b|^2 counts the curvature energy threefold on an equilateral mesh; w is a third of it.
#pragma once

#include "solver/model/hinge.h"

namespace ease {

/// Elasticity and damping of one hinge over a step: w/2 |b|^2 + w_d/(2h) (|b| - |b_start|)^2.
/// The rate is of |b|, not of b, so that a rigid motion is not damped.
struct HingeSpring {
  double w;               // J
  double damping_over_h;  // J
  double start;           // |b| at the start of the step
};

double bendingEnergy(const Vec3& b, const HingeSpring& spring);  // J
Vec3 bendingGradient(const Vec3& b, const HingeSpring& spring);  // by b, J
/// Second derivative by b, J, without negative part: alpha I + beta b bᵀ/|b|².
Mat3 bendingHessian(const Vec3& b, const HingeSpring& spring);

}  // namespace ease
