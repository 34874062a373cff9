#include "solver/energy/stretch.h"

namespace ease {

Mat3 stretchHessian(const Vec3& f, const Spring& spring, HessianKind kind) {
  const double now = f.norm();
  if (now == 0.0) return Mat3::Zero();
  const Vec3 along = f / now;
  const double across = keptEigenvalue(1.0 - spring.c / now, kind);
  return spring.k * (across * Mat3::Identity() + (1.0 - across) * along * along.transpose());
}

}  // namespace ease
