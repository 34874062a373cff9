#include "viz/color_scale.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace ease {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Colours at equal distances: kBelow from the lowest value to the limit, kOver from the limit to the highest value.
const std::vector<Rgb> kBelow = {{234, 242, 248}, {190, 214, 229}, {124, 176, 211}};
const std::vector<Rgb> kOver = {{243, 112, 33}, {201, 42, 28}, {122, 8, 38}};
constexpr Rgb kNotANumber = {128, 128, 128};

// Matrices of Ottosson 2020: from linear sRGB to cone responses, and from the cube roots of these to Oklab.
const Matrix3d kToCones{{0.4122214708, 0.5363325363, 0.0514459929},
                        {0.2119034982, 0.6806995451, 0.1073969566},
                        {0.0883024619, 0.2817188376, 0.6299787005}};
const Matrix3d kToLab{{0.2104542553, 0.7936177850, -0.0040720468},
                      {1.9779984951, -2.4285922050, 0.4505937099},
                      {0.0259040371, 0.7827717662, -0.8086757660}};

/// Converts an sRGB component to linear light by the transfer function of IEC 61966-2-1; both are in [0, 1].
double toLinear(double s) {
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// Converts linear light to an sRGB component, the inverse of toLinear().
double fromLinear(double l) {
  return l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
}

Vector3d toOklab(const Rgb& color) {
  Vector3d linear;
  for (int i = 0; i < 3; ++i) linear[i] = toLinear(color[i] / 255.0);
  return kToLab * (kToCones * linear).unaryExpr([](double x) { return std::cbrt(x); });
}

Rgb fromOklab(const Vector3d& lab) {
  static const Matrix3d kFromLab = kToLab.inverse(), kFromCones = kToCones.inverse();
  const Vector3d cones = (kFromLab * lab).array().cube();
  const Vector3d linear = kFromCones * cones;
  Rgb color;
  for (int i = 0; i < 3; ++i) {
    color[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(fromLinear(linear[i]), 0.0, 1.0)));
  }
  return color;
}

std::vector<Vector3d> inOklab(const std::vector<Rgb>& colors) {
  std::vector<Vector3d> lab;
  for (const Rgb& color : colors) lab.push_back(toOklab(color));
  return lab;
}

/// Interpolates colours in Oklab piecewise linearly; `where` is 0 at the first colour and 1 at the last.
Rgb interpolate(const std::vector<Vector3d>& colors, double where) {
  const double scaled = where * static_cast<double>(colors.size() - 1);
  const std::size_t first = std::min(static_cast<std::size_t>(scaled), colors.size() - 2);
  const double t = scaled - static_cast<double>(first);
  return fromOklab((1 - t) * colors[first] + t * colors[first + 1]);
}

double fraction(double value, double from, double to) {
  return to > from ? std::clamp((value - from) / (to - from), 0.0, 1.0) : 0.0;
}

}  // namespace

Rgb ColorScale::color(double value) const {
  static const std::vector<Vector3d> below = inOklab(kBelow), over = inOklab(kOver);
  if (std::isnan(value)) return kNotANumber;
  if (isOver(value)) return interpolate(over, fraction(value, limit_, high_));
  return interpolate(below, fraction(value, low_, limit_));
}

double lightness(const Rgb& color) {
  return toOklab(color)[0];
}

double tickStep(double range, int intervals) {
  const double least = range / intervals;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10 * power;
}

}  // namespace ease
