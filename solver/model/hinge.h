// Hinge: two triangles that share an edge, and the stencil that measures how far they are from flat.
//
//          x2
//         /  \        b = sum_i K_i x_i     3, m: zero where the four vertices lie in a plane
//        / A0 \      .
//      x0------x1     K from the cotangents of the rest shape (Bergou et al. 2006), constant between rest shapes
//        \ A1 /
//         \  /
//          x3
#pragma once

#include <array>

#include "solver/mesh/triangle_gradient.h"

namespace ease {

struct Hinge {
  std::array<int, 4> vertices;    // x0, x1 on the edge, x2, x3 opposite
  std::array<double, 4> stencil;  // K, dimensionless
  double inverse_area;            // 1/(A0 + A1), 1/m^2
};

/// Stencil from the cotangents of two flat triangles that share an edge: `first` = (x0, x1, x2) and `second` =
/// (x1, x0, x3), each given by its 2x2 edges D in any frame of its own.
Hinge makeHinge(const std::array<int, 4>& vertices, const Mat2& first, const Mat2& second);

/// Computes b, m.
Vec3 hingeVector(const Hinge& hinge, const Positions& x);

}  // namespace ease
