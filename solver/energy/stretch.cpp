#include "solver/energy/stretch.h"

namespace ease {

Mat3 stretchHessian(const Vec3& f, const Spring& spring, HessianKind kind, double softening) {
  const double now = f.norm();
  if (now == 0.0) return Mat3::Zero();
  if (now < 1.0 && softening > 0.0) {  // where it is compressed, the thread is another spring
    const double k = spring.k - softening;
    return k > 0.0 ? stretchHessian(f, {k, (spring.k * spring.c - softening) / k}, kind) : Mat3(Mat3::Zero());
  }
  const Vec3 along = f / now;
  const double across = keptEigenvalue(1.0 - spring.c / now, kind);
  return spring.k * (across * Mat3::Identity() + (1.0 - across) * along * along.transpose());
}

}  // namespace ease
