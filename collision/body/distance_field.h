// Shapes given by a field of signed distances.
#pragma once

#include <functional>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Signed distance to a shape (m, negative inside) and its gradient, of about unit length.
struct Distance {
  double value;
  Vec3 gradient;
};

/// Gives the distance of any point (m) to a shape; the shape's surface is where it is zero.
using DistanceField = std::function<Distance(const Vec3&)>;

}  // namespace ease
