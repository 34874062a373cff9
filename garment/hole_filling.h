// Closes holes of a body mesh: eye sockets, mouths, cut wrists, places that the scanner did not see.
//
// A hole is closed by triangles between the vertices of its edge that fold least, and among these have the least area
// (Liepa 2003, by CGAL). No vertex is added, so that one set of triangles closes the hole in every pose.
#pragma once

#include <string>
#include <vector>

#include "solver/mesh/topology.h"

namespace ease {

struct Hole {
  std::vector<int> loop;  // its vertices, in the direction of the triangles around it
  Vec3 centre;            // mean of its vertices, m
  double width_m = 0.0;   // diagonal of the box around it
};

/// The holes of a mesh, one for each boundary loop.
std::vector<Hole> holesOf(const TriangleMesh& mesh, const Topology& topology);

/// Triangles that close the hole. Throws InputError, naming `name` and the hole's place, where none fit.
Triangles patchFor(const Hole& hole, const Positions& positions, const std::string& name);

}  // namespace ease
