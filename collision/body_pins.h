// Points that follow the moving body: each keeps its place relative to the body's triangle nearest to it.
//
//   x = a + l_1 (b - a) + l_2 (c - a) + l_3 n     (a, b, c) the triangle's corners, n its unit normal;
//                                                 l_1 and l_2 dimensionless, l_3 in m
#pragma once

#include <vector>

#include "collision/body_moment.h"

namespace ease {

/// Ties a point to a triangle of the body.
struct BodyTie {
  int triangle;
  Vec3 local;  // (l_1, l_2, l_3)
};

/// Ties the listed vertices of the cloth, at positions `x`, to the body's surface at positions `body`.
std::vector<BodyTie> tieToBody(const std::vector<int>& vertices, const Positions& x, const Positions& body,
                               const Triangles& triangles);

/// Position of the tied point at this moment, m.
Vec3 placeOf(const BodyTie& tie, const BodyMoment& body);

}  // namespace ease
