#include "solver/energy/shear.h"

#include <algorithm>
#include <cmath>

namespace ease {

namespace {

// The bias directions, their lengths, and unit vectors along them (zero where the length is).
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

double shearCondition(const Mat32& F) {
  return Bias(F).condition();
}

double shearEnergy(const Mat32& F, const Spring& spring) {
  const double excess = shearCondition(F) - spring.c;
  return 0.5 * spring.k * excess * excess;
}

Mat32 shearGradient(const Mat32& F, const Spring& spring) {
  const Bias bias(F);
  const double tension = spring.k * (bias.condition() - spring.c) * M_SQRT1_2;
  Mat32 gradient;
  gradient.col(0) = tension * (bias.plus - bias.minus);
  gradient.col(1) = tension * (bias.plus + bias.minus);
  return gradient;
}

FrameHessian shearHessian(const Mat32& F, const Spring& spring) {
  // In (d+, d-) the eigenvectors are (plus, -minus) along the bias and whatever is across plus or minus: one of the
  // two across terms is negative, and goes.
  const Bias bias(F);
  const double excess = bias.condition() - spring.c;
  const double across_plus = bias.plus_length > 0.0 ? std::max(0.0, excess) / bias.plus_length : 0.0;
  const double across_minus = bias.minus_length > 0.0 ? std::max(0.0, -excess) / bias.minus_length : 0.0;
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

}  // namespace ease
