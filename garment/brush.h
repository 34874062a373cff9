// A brush acts inside a ball: fully within half its radius, then fading smoothly to nothing at the radius.
#pragma once

#include <algorithm>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct Brush {
  Vec3 at;        // m
  double radius;  // m
  double value;   // the painted value: a scale factor, or an offset in m
};

/// Weight of the brush at `x`: 1 within half the radius, 0 beyond the radius, and between them a cubic that joins both
/// smoothly.
inline double brushWeight(const Brush& brush, const Vec3& x) {
  const double s = std::clamp(2.0 * (1.0 - (x - brush.at).norm() / brush.radius), 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

}  // namespace ease
