// Damping of bending at one hinge, or, with Real = Lanes, at eight side by side. The elastic part is quadratic
// (step/hinge_forces.h, step/bending_matrix.h).
//
//   b = sum_i K_i x_i   hinge vector, 3, m; zero where the four vertices lie in a plane (hinge.h)
//   w = D / (A0 + A1)   D bending stiffness, N m; A0, A1 rest areas beside the edge
//   energy  w/2 |b|^2,  J                          elastic (Bergou et al. 2006; Wardetzky et al. 2007)
//   energy  w_d/(2h) (|b| - |b_start|)^2,  J       damping over a step of length h, s; w_d as w, with the damping
//                                                  coefficient in place of D
//
// Damping acts on the length |b| and not on b itself, because b turns with the cloth: a rigid motion must not be
// damped. The form in these papers, 1/2 3/(A0+A1) |b|^2, is three times the curvature energy on an equilateral mesh; w
// is therefore a third of it.
#pragma once

#include "solver/energy/element.h"
#include "solver/model/hinge.h"

namespace ease {

constexpr double kShortestBending = 1e-200;  // m: divisor where |b| is zero

template <class Real>
struct HingeDamper {
  Real damping_over_h;  // w_d/h, N/m
  Real start;           // |b| at the start of the step, m

  /// Damping energy, J; `bending`: |b|, m.
  Real energy(const Real& bending) const {
    const Real rate = bending - start;
    return 0.5 * damping_over_h * rate * rate;
  }
  /// The derivative of the energy with respect to b, N, is this, N/m, times b.
  Real weight(const Real& bending) const {
    return damping_over_h * (bending - start) / larger(bending, kShortestBending);
  }
};

/// Second derivative of the damping energy with respect to b, N/m. Zero where b is zero.
Mat3 hingeDampingHessian(const Vec3& b, const HingeDamper<double>& damper, HessianKind kind);

}  // namespace ease
