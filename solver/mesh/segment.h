// The point of a segment that is nearest to a given point, in the plane or in space.
#pragma once

#include <algorithm>

namespace ease {

/// The point of the segment from a to b that is nearest to x, in the unit of the three.
template <class Point>
Point nearestOnSegment(const Point& a, const Point& b, const Point& x) {
  const Point ab = b - a;
  const double length2 = ab.squaredNorm();
  return a + (length2 > 0.0 ? std::clamp(ab.dot(x - a) / length2, 0.0, 1.0) : 0.0) * ab;
}

/// Distance of x from the segment from a to b.
template <class Point>
double distanceToSegment(const Point& a, const Point& b, const Point& x) {
  return (nearestOnSegment(a, b, x) - x).norm();
}

}  // namespace ease
