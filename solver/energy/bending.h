// Damping of bending, hinge by hinge; the elastic part is quadratic and kept as a matrix (bending_matrix.h).
//
//   b = sum_i K_i x_i   hinge vector, 3, m; zero where the four vertices lie in a plane (hinge.h)
//   w = D / (A0 + A1)   D bending stiffness, N m; A0, A1 rest areas beside the edge
//   energy  w/2 |b|^2,  J                          elastic (Bergou et al. 2006; Wardetzky et al. 2007)
//   energy  w_d/(2h) (|b| - |b_start|)^2,  J       damping; of |b|, not of b, so that a rigid motion is not damped
//
// Their form 1/2 3/(A0+A1) |b|^2 counts the curvature energy threefold on an equilateral mesh; w is a third of it.
#pragma once

#include "solver/energy/element.h"
#include "solver/model/hinge.h"

namespace ease {

struct HingeDamper {
  double damping_over_h;  // w_d/h, N/m
  double start;           // |b| at the start of the step, m
};

double hingeDamping(const Vec3& b, const HingeDamper& damper);        // J
Vec3 hingeDampingGradient(const Vec3& b, const HingeDamper& damper);  // by b, N
/// Second derivative by b, N/m.
Mat3 hingeDampingHessian(const Vec3& b, const HingeDamper& damper, HessianKind kind);

}  // namespace ease
