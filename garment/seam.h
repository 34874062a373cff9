// Tool 6: seams, lines along which the garment can be cut for its sewing pattern.
//
// A seam is asked for as the shortest path from loop to loop, by way of points; as a closed path through points; or as
// a line along which a plane cuts.  It becomes a chain of the mesh's edges near that line; the chain's vertices are
// then moved onto the line, evenly spaced, and their surroundings relaxed with them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "garment/boundary_loop.h"
#include "garment/looped_mesh.h"

namespace ease {

struct SeamRequest {
  std::string name;
  std::string from, to;      // loops; both empty: closed
  std::vector<Vec3> points;  // m: on its way
  std::optional<PlaneNear> plane;
};

struct Seam {
  std::string name;
  std::vector<int> vertices;  // neighbours by edges of the mesh
  bool is_closed = false;
};

/// Finds the seams, in the order of the requests, and moves the garment's vertices within its surface so that they run
/// smoothly.  Throws InputError naming the seam: a loop that does not exist, a point far from the garment, points that
/// are not connected, a plane that cuts nothing, too short a line for the mesh.
std::vector<Seam> findSeams(const std::vector<SeamRequest>& requests, LoopedMesh& garment);

}  // namespace ease
