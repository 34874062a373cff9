// Contact of one sample of the cloth: a spring that stiffens with depth.
//
//   depth   how far the sample is below its contact plane, m; no force above it
//   k       stiffness at first touch, N/m^3 (pressure per depth)
//   l       give: depth at which the pressure has trebled, m
//
//   psi = k/2 depth^2 + k/(2 l^2) depth^4,   J/m^2
//   p   = k depth (1 + 2 (depth/l)^2),       Pa
//
// Soft where cloth just lies on the body, so that it comes to rest there; stiff before it can sink in by more than the
// comfort offset, also where a taut edge hangs on a single vertex (a closed armpit).
#pragma once

namespace ease {

/// J/m^2.  Real: double, or eight side by side.
template <class Real>
Real contactEnergy(const Real& depth, double k, const Real& l) {
  const Real r = depth / l;
  return 0.5 * k * depth * depth * (1.0 + r * r);
}

/// Pa: d psi / d depth
template <class Real>
Real contactPressure(const Real& depth, double k, const Real& l) {
  const Real r = depth / l;
  return k * depth * (1.0 + 2.0 * r * r);
}

/// N/m^3: second derivative, positive
inline double contactStiffness(double depth, double k, double l) {
  const double r = depth / l;
  return k * (1.0 + 6.0 * r * r);
}

}  // namespace ease
