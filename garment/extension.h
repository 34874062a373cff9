// Tool 2: extends a garment, as by a skirt or a wide sleeve: a loop is duplicated, moved along its axis, scaled and
// joined with the garment.
//
//   c = sum_i l_i p_i / sum_i l_i       centre of mass of the loop, l_i half the length of its edges at vertex i
//   A = 1/2 sum_i p_i x p_(i+1)         vector area, m^2; the axis A / |A|, turned away from the garment
//   q_i = c + move + scale (p_i - c)    the new loop: right for loops that are not plane too
//
// After Wolff et al. 2022.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "garment/looped_mesh.h"

namespace ease {

struct Extension {
  std::string loop;        // name of the loop that moves; the new loop keeps it
  std::optional<Vec3> to;  // where its centre of mass goes, m
  double length = 0.0;     // or how far it goes along the axis, m
  double scale = 1.0;
};

/// Centre of mass of a closed polygon, m.
Vec3 centreOfMass(const std::vector<Vec3>& loop);

/// Vector area of a closed polygon, m^2, the same from any origin.
Vec3 vectorArea(const std::vector<Vec3>& loop);

/// Adds the extension, in rows of triangles about `edge_length` (m) high.  Throws InputError naming a loop that the
/// garment does not have or that has no axis.
void extend(const Extension& extension, double edge_length, LoopedMesh& garment);

}  // namespace ease
