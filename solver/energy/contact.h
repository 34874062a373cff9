// Contact of one sample point of the cloth with the body: a spring that stiffens with depth.
//
//   depth   how far the sample is below its contact plane, m; there is no force above the plane
//   k       stiffness at first touch, N/m^3 (pressure per depth)
//   l       give, m: the depth at which the pressure is three times that of a linear spring
//
//   psi = k/2 depth^2 + k/(2 l^2) depth^4,   J/m^2
//   p   = k depth (1 + 2 (depth/l)^2),       Pa
//
// The spring is soft where cloth merely lies on the body, so that the cloth comes to rest there. It becomes stiff
// before the cloth sinks in by more than the comfort offset, even where a single vertex carries a taut edge (as in a
// closed armpit).
#pragma once

namespace ease {

/// Contact energy psi, J/m^2. Real is double for one sample, or Lanes (element.h) for eight side by side.
template <class Real>
Real contactEnergy(const Real& depth, double k, const Real& l) {
  const Real r = depth / l;
  return 0.5 * k * depth * depth * (1.0 + r * r);
}

/// Contact pressure, Pa: d psi / d depth.
template <class Real>
Real contactPressure(const Real& depth, double k, const Real& l) {
  const Real r = depth / l;
  return k * depth * (1.0 + 2.0 * r * r);
}

/// Second derivative of psi with respect to depth, N/m^3. Always positive.
inline double contactStiffness(double depth, double k, double l) {
  const double r = depth / l;
  return k * (1.0 + 6.0 * r * r);
}

}  // namespace ease
