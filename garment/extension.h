// Tool 3: extends a garment, for example by a skirt or a wide sleeve.  A loop is duplicated, moved along its axis,
// scaled and joined with the garment.
//
//   c = sum_i l_i p_i / sum_i l_i       centre of mass of the loop, l_i half the length of its edges at vertex i
//   A = 1/2 sum_i p_i x p_(i+1)         vector area, m^2; the axis is A / |A|, turned away from the garment
//   q_i = c + move + scale (p_i - c)    the new loop, which need not be plane
//
// This follows Wolff et al. 2022.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "garment/looped_mesh.h"

namespace ease {

struct Extension {
  std::string loop;        // name of the loop to extend; the new loop takes over the name
  std::optional<Vec3> to;  // target of its centre of mass, m
  double length = 0.0;     // without `to`: distance to move along the axis, m
  double scale = 1.0;
};

/// Centre of mass of a closed polygon, m.
Vec3 centreOfMass(const std::vector<Vec3>& loop);

/// Vector area of a closed polygon, m^2; it does not depend on the origin.
Vec3 vectorArea(const std::vector<Vec3>& loop);

/// Adds the extension, in rows of triangles about `edge_length` (m) high.  Throws InputError naming a loop that does
/// not exist or has no axis.
void extend(const Extension& extension, double edge_length, LoopedMesh& garment);

}  // namespace ease
