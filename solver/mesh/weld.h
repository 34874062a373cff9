// Closes open edges of a mesh where another open edge lies at the same place: seams of texture coordinates, panels
// exported one by one, and STL files, whose triangles share nothing.
//
// Two vertices become one only as ends of two such edges that run in opposite directions. Where a surface merely
// touches itself, in a vertex or along a closed edge, nothing changes. Where more than two open edges meet, they are
// joined in pairs that lie next to each other around them, with the inside between the two.
#pragma once

#include <span>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct Weld {
  std::vector<int> vertex;  // new number of each vertex, in the order of the old ones; -1: no triangle uses it
  int count = 0;            // of vertices afterwards
  int welded = 0;           // vertices that became one with an earlier one
  int unused = 0;           // vertices that no triangle uses
  int left_open = 0;        // open edges at the place of another one that could not be joined

  bool changesNothing() const { return welded == 0 && unused == 0; }
};

/// Finds what to weld. `poses`: positions of the vertices, m, one entry a pose, at least one; what lies apart in one of
/// them stays apart. Places count as one up to 1e-6 of the diagonal of the mesh. `joins`: false to only drop vertices
/// that no triangle uses.
Weld findWeld(const Triangles& triangles, std::span<const Positions> poses, bool joins);

Triangles welded(const Triangles& triangles, const Weld& weld);
/// Each vertex takes the place of the first of those that it stands for.
Positions welded(const Positions& positions, const Weld& weld);

}  // namespace ease
