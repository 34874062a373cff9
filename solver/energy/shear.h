// Shear of a triangle: the difference of its two bias stretches.
//
//   F = [f_u f_v]              3x2 deformation gradient
//   d+- = (f_u +- f_v)/sqrt 2  bias directions
//   C = |d+| - |d-|            zero exactly where f_u is orthogonal to f_v; f_u . f_v to second order near F's rest
//   psi = k/2 (C - c)^2        k in N/m; c as in stretch.h
//
// For c = 0 this is k times the squared distance of F to the nearest pair of orthogonal columns, so that a projective
// method reproduces it exactly.
#pragma once

#include "solver/energy/stretch.h"

namespace ease {

/// C, dimensionless.
double shearCondition(const Mat32& F);

/// psi, N/m.
double shearEnergy(const Mat32& F, const Spring& spring);

/// d psi / d F, 3x2, N/m.
Mat32 shearGradient(const Mat32& F, const Spring& spring);

/// Blocks of the second derivative by (f_u, f_v), each 3x3, N/m: uu, uv (row f_u, column f_v), vv.
struct FrameHessian {
  Mat3 uu, uv, vv;
};

/// Second derivative by F, its negative part set to zero.
FrameHessian shearHessian(const Mat32& F, const Spring& spring);

}  // namespace ease
