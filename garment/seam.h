// Tool 7: seams, lines along which the garment can be cut for its sewing pattern.
//
// A seam is requested in one of four ways: the shortest path between two loops through given points; a path from a loop
// to its last point inside the garment (a dart); a closed path through points; or the line along which a plane cuts.
// The seam becomes a chain of mesh edges near that line; the chain's vertices are then moved onto the line, evenly
// spaced, and their surroundings relaxed with them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "garment/boundary_loop.h"
#include "garment/looped_mesh.h"

namespace ease {

struct SeamRequest {
  std::string name;
  std::string from, to;      // names of loops or of seams above it; both empty: closed; `to` empty: a dart
  std::vector<Vec3> points;  // m: points that the seam passes
  std::optional<PlaneNear> plane;
};

struct Seam {
  std::string name;
  std::vector<int> vertices;  // consecutive vertices share an edge of the mesh
  bool is_closed = false;
};

/// Finds the seams, in the order of the requests, and moves the garment's vertices within its surface so that they run
/// smoothly.  Throws InputError naming the seam if a loop does not exist, a point is far from the garment, points are
/// not connected, a plane cuts nothing, or the line is too short for the mesh.
std::vector<Seam> findSeams(const std::vector<SeamRequest>& requests, LoopedMesh& garment);

}  // namespace ease
