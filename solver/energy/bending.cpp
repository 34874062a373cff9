#include "solver/energy/bending.h"

namespace ease {

double hingeDamping(const Vec3& b, const HingeDamper& damper) {
  const double rate = b.norm() - damper.start;
  return 0.5 * damper.damping_over_h * rate * rate;
}

Vec3 hingeDampingGradient(const Vec3& b, const HingeDamper& damper) {
  const double length = b.norm();
  return length > 0.0 ? Vec3(damper.damping_over_h * (1.0 - damper.start / length) * b) : Vec3::Zero();
}

Mat3 hingeDampingHessian(const Vec3& b, const HingeDamper& damper, HessianKind kind) {
  const double length = b.norm();
  if (length == 0.0) return Mat3::Zero();
  const double across = damper.damping_over_h * keptEigenvalue(1.0 - damper.start / length, kind);
  const Vec3 along = b / length;
  return across * Mat3::Identity() + (damper.damping_over_h - across) * along * along.transpose();
}

}  // namespace ease
