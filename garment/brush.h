// A brush acts inside a ball, or along a stroke: fully within half its radius, then fading smoothly to nothing at the
// radius.  A stroke is one brush, so that it may pass a place twice without acting there twice.
#pragma once

#include <algorithm>
#include <vector>

#include "solver/mesh/segment.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct Brush {
  Vec3 at;                        // m; of a stroke, its first point
  double radius;                  // m
  double value;                   // the painted value: a scale factor, or an offset in m
  std::vector<Vec3> stroke = {};  // m: the brush moves along these points in their order; empty: it stays
};

/// Distance from `x` to the brush's centre or, of a stroke, to the line along which that moves, m.
inline double distanceTo(const Brush& brush, const Vec3& x) {
  double nearest = (x - brush.at).norm();
  for (size_t k = 1; k < brush.stroke.size(); ++k)
    nearest = std::min(nearest, distanceToSegment(brush.stroke[k - 1], brush.stroke[k], x));
  return nearest;
}

/// Weight of the brush at `x`: 1 within half the radius, 0 beyond the radius, and between them a cubic that joins both
/// smoothly.
inline double brushWeight(const Brush& brush, const Vec3& x) {
  const double s = std::clamp(2.0 * (1.0 - distanceTo(brush, x) / brush.radius), 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

}  // namespace ease
