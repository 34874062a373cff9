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

struct ContactSpring {
  double k;
  double l;
};

double contactEnergy(double depth, const ContactSpring& spring);     // J/m^2
double contactPressure(double depth, const ContactSpring& spring);   // Pa: d psi / d depth
double contactStiffness(double depth, const ContactSpring& spring);  // N/m^3: second derivative, positive

}  // namespace ease
