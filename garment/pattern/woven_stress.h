// Energy and stress of a triangle of woven cloth in the plane (flattening.h).
#pragma once

#include <cmath>

#include "garment/pattern/flattening.h"

namespace ease {

/// F = S R: S symmetric, R the rotation nearest to F.
struct LeftPolar {
  Mat2 S, R;
};

inline LeftPolar leftPolar(const Mat2& F) {
  const double x = F(0, 0) + F(1, 1), y = F(1, 0) - F(0, 1), length = std::sqrt(x * x + y * y);
  const double c = length > 0.0 ? x / length : 1.0, s = length > 0.0 ? y / length : 0.0;
  LeftPolar polar;
  polar.R << c, -s, s, c;
  polar.S = F * polar.R.transpose();
  return polar;
}

/// Shear as S_uv that is soft; what is above it is as stiff as the threads.
inline double softShear(double shear, const WovenSettings& settings) {
  const double most = 0.5 * settings.shear_limit;
  return std::clamp(shear, -most, most);
}

/// By how much cloth is smaller than at rest, as a symmetric tensor: S with its eigenvalues less one, where negative.
inline Mat2 shortfall(const Mat2& S) {
  const double mean = 0.5 * (S(0, 0) + S(1, 1)), half = 0.5 * (S(0, 0) - S(1, 1)), radius = std::hypot(half, S(0, 1));
  const double larger = std::min(0.0, mean + radius - 1.0), smaller = std::min(0.0, mean - radius - 1.0);
  Mat2 part = 0.5 * (larger + smaller) * Mat2::Identity();
  if (radius > 0.0) {
    Mat2 apart;
    apart << half, S(0, 1), S(0, 1), -half;
    part += 0.5 * (larger - smaller) / radius * apart;
  }
  return part;
}

/// Per area.
inline double wovenEnergy(const Mat2& F, const WovenSettings& settings) {
  const Mat2 S = leftPolar(F).S;
  const double u = S(0, 0) - 1.0, v = S(1, 1) - 1.0, soft = softShear(S(0, 1), settings), hard = S(0, 1) - soft;
  const double woven =
      settings.warp * u * u + settings.weft * v * v +
      2.0 * (settings.shear * soft * soft + 2.0 * settings.shear * std::abs(soft * hard) + hard * hard);
  return settings.excess * woven + (1.0 - settings.excess) * shortfall(S).squaredNorm();
}

/// Half the derivative of the energy by F, where R is held.
inline Mat2 wovenStress(const Mat2& F, const WovenSettings& settings) {
  const LeftPolar polar = leftPolar(F);
  const Mat2& S = polar.S;
  const double soft = softShear(S(0, 1), settings);
  const double shear = settings.shear * soft + (S(0, 1) - soft);
  Mat2 stress;
  stress << settings.warp * (S(0, 0) - 1.0), shear, shear, settings.weft * (S(1, 1) - 1.0);
  return (settings.excess * stress + (1.0 - settings.excess) * shortfall(S)) * polar.R;
}

}  // namespace ease
