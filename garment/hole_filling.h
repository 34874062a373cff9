// Closes holes of a body: eye sockets, mouths, cut wrists, what a scanner did not see.
//
// A hole is closed with triangles between the vertices of its edge, of the smallest area and the least folded (Liepa
// 2003, as CGAL has it). No vertex is added, so that all poses can be closed as the first one was.
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

std::vector<Hole> holesOf(const TriangleMesh& mesh, const Topology& topology);

/// Triangles that close the hole. Throws InputError, naming `name` and the hole's place, where none fit.
Triangles patchFor(const Hole& hole, const Positions& positions, const std::string& name);

}  // namespace ease
