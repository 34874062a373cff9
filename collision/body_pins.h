// Points that follow the body: each stays where it was relative to the nearest triangle.
#pragma once

#include <vector>

#include "collision/contacts.h"
#include "collision/triangle_tree.h"

namespace ease {

struct BodyTie {
  int triangle;
  Vec3 local;  // coordinates by the triangle's edges and its unit normal from its first vertex: 1, 1, m
};

/// Ties these vertices of the cloth at `x` to the body as it is in `body`.
std::vector<BodyTie> tieToBody(const std::vector<int>& vertices, const Positions& x, const Positions& body,
                               const Triangles& triangles);

/// Where the point is at this moment, m.
Vec3 placeOf(const BodyTie& tie, const BodyMoment& body);

}  // namespace ease
