#include "solver/energy/bending.h"

#include <algorithm>

namespace ease {

double bendingEnergy(const Vec3& b, const HingeSpring& spring) {
  const double rate = b.norm() - spring.start;
  return 0.5 * spring.w * b.squaredNorm() + 0.5 * spring.damping_over_h * rate * rate;
}

Vec3 bendingGradient(const Vec3& b, const HingeSpring& spring) {
  const double length = b.norm();
  const double rate = length > 0.0 ? 1.0 - spring.start / length : 0.0;
  return (spring.w + spring.damping_over_h * rate) * b;
}

Mat3 bendingHessian(const Vec3& b, const HingeSpring& spring) {
  const double length = b.norm();
  if (length == 0.0) return spring.w * Mat3::Identity();
  const double across = spring.damping_over_h * std::max(0.0, 1.0 - spring.start / length);
  const Vec3 along = b / length;
  return (spring.w + across) * Mat3::Identity() + (spring.damping_over_h - across) * along * along.transpose();
}

}  // namespace ease
