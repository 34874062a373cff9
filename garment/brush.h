// A brush: acts on all within a ball, in full within half its radius, then fading smoothly to nothing.
#pragma once

#include <algorithm>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct Brush {
  Vec3 at;        // m
  double radius;  // m
  double value;   // what is painted: a scale factor, an offset in m
};

/// 1 within half the radius, 0 beyond the radius, and a cubic between that joins both smoothly.
inline double brushWeight(const Brush& brush, const Vec3& x) {
  const double s = std::clamp(2.0 * (1.0 - (x - brush.at).norm() / brush.radius), 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

}  // namespace ease
