#include "solver/energy/shear.h"

#include <cmath>

namespace ease {

namespace {

/// Lengths of the bias directions d+ and d-, and unit vectors along them (zero vectors where the length is zero).
struct Bias {
  double plus_length, minus_length;
  Vec3 plus, minus;

  explicit Bias(const Mat32& F) : plus((F.col(0) + F.col(1)) * M_SQRT1_2), minus((F.col(0) - F.col(1)) * M_SQRT1_2) {
    plus_length = plus.norm();
    minus_length = minus.norm();
    if (plus_length > 0.0) plus /= plus_length;
    if (minus_length > 0.0) minus /= minus_length;
  }
  double condition() const { return plus_length - minus_length; }
};

}  // namespace

double orthogonalShear(const Mat32& F) {
  return Bias(F).condition();
}

FrameHessian orthogonalShearHessian(const Mat32& F, const Spring& spring, HessianKind kind) {
  // Written in (d+, d-), the Hessian has the eigenvector (plus, -minus) along the bias directions; its other
  // eigenvectors are perpendicular to plus in d+ or to minus in d-. The eigenvalues of these two kinds have opposite
  // signs, so one of them is negative.
  const Bias bias(F);
  const double excess = bias.condition() - spring.c;
  const double across_plus = bias.plus_length > 0.0 ? keptEigenvalue(excess / bias.plus_length, kind) : 0.0;
  const double across_minus = bias.minus_length > 0.0 ? keptEigenvalue(-excess / bias.minus_length, kind) : 0.0;
  const Mat3 pp = bias.plus * bias.plus.transpose();
  const Mat3 mm = bias.minus * bias.minus.transpose();
  const Mat3 pm = bias.plus * bias.minus.transpose();
  const Mat3 plus_plus = pp + across_plus * (Mat3::Identity() - pp);
  const Mat3 minus_minus = mm + across_minus * (Mat3::Identity() - mm);

  const double half = 0.5 * spring.k;
  FrameHessian hessian;
  hessian.uu = half * (plus_plus + minus_minus - pm - pm.transpose());
  hessian.uv = half * (plus_plus - minus_minus + pm - pm.transpose());
  hessian.vv = half * (plus_plus + minus_minus + pm + pm.transpose());
  return hessian;
}

FrameHessian bw98ShearHessian(const Mat32& F, const Spring& spring, HessianKind kind) {
  // H = k [q qᵀ + (C - c) (0 I; I 0)] with q = (f_v, f_u).
  Mat32 q;
  q << F.col(1), F.col(0);
  FrameHessian hessian;
  hessian.addMode(spring.k, q);
  hessian.uv.diagonal().array() += spring.k * (bw98Shear(F) - spring.c);
  return kind == HessianKind::projected ? projected(hessian) : hessian;
}

}  // namespace ease
