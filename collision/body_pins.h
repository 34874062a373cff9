// Pins that follow the body: each holds its vertex where it was relative to the nearest triangle.
#pragma once

#include <vector>

#include "collision/contacts.h"
#include "collision/triangle_tree.h"

namespace ease {

class BodyPins {
 public:
  /// Ties these vertices of the cloth at `x` to the body as it is in `body`.
  BodyPins(const std::vector<int>& vertices, const Positions& x, const Positions& body, const Triangles& triangles);

  /// Appends the pins' places on the body at this moment, m, in the order of the vertices.
  void place(const BodyMoment& body, std::vector<Vec3>& places) const;

 private:
  struct Tie {
    int triangle;
    Vec3 local;  // coordinates by the triangle's edges and its unit normal from its first vertex: 1, 1, m
  };
  std::vector<Tie> ties_;
};

}  // namespace ease
