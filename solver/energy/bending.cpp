#include "solver/energy/bending.h"

namespace ease {

Mat3 hingeDampingHessian(const Vec3& b, const HingeDamper<double>& damper, HessianKind kind) {
  const double length = b.norm();
  if (length == 0.0) return Mat3::Zero();
  const double across = damper.damping_over_h * keptEigenvalue(1.0 - damper.start / length, kind);
  const Vec3 along = b / length;
  return across * Mat3::Identity() + (damper.damping_over_h - across) * along * along.transpose();
}

}  // namespace ease
