#include "solver/energy/stretch.h"

#include <algorithm>

namespace ease {

double stretchEnergy(const Vec3& f, const Spring& spring) {
  const double excess = f.norm() - spring.c;
  return 0.5 * spring.k * excess * excess;
}

Vec3 stretchGradient(const Vec3& f, const Spring& spring) {
  const double length = f.norm();
  if (length == 0.0) return Vec3::Zero();
  return spring.k * (1.0 - spring.c / length) * f;
}

Mat3 stretchHessian(const Vec3& f, const Spring& spring) {
  const double length = f.norm();
  if (length == 0.0) return Mat3::Zero();
  const Vec3 along = f / length;
  const double across = std::max(0.0, 1.0 - spring.c / length);
  return spring.k * (across * Mat3::Identity() + (1.0 - across) * along * along.transpose());
}

}  // namespace ease
