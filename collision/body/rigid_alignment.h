// How a person stands in one scan and in the next: the turn about the vertical and the shift that bring the second
// nearest to the first, in the least-squares sense over their vertices.
//
//   y_i - to_centre = turn (x_i - from_centre)     x_i, y_i  vertices of the first and the second scan, m
#pragma once

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct Standing {
  double turn_rad = 0.0;        // about y, from `from` to `to`, -pi to pi
  Vec3 from_centre, to_centre;  // means of the vertices, m

  /// Distance between the two centres, m.
  double shift_m() const { return (to_centre - from_centre).norm(); }
};

/// The rigid motion about the vertical (y) between two poses with the same vertices.
Standing standingBetween(const Positions& from, const Positions& to);

/// Moves `to` back by it, so that it stands where `from` does.
void standAs(const Standing& standing, Positions& to);

}  // namespace ease
