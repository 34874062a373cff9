// Measures the quality of an authored mesh: shape and size of its triangles, self-intersections, distance to the body.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "collision/triangle_tree.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct MeshQuality {
  int vertices = 0, triangles = 0;
  double smallest_angle_deg = 0.0, largest_angle_deg = 0.0;
  double share_from_20_deg = 0.0;  // share of triangles whose smallest angle is at least 20 degrees
  double shortest_edge_m = 0.0, mean_edge_m = 0.0, longest_edge_m = 0.0;
  int self_intersections = 0;  // pairs of triangles that cross
  // Smallest distances to the body.
  double vertex_distance_m = 0.0, midpoint_distance_m = 0.0, centroid_distance_m = 0.0;
  double nearest() const { return std::min({vertex_distance_m, midpoint_distance_m, centroid_distance_m}); }
  int too_near = 0;  // vertices, midpoints and centroids nearer than the comfort offset by more than 0.01 mm
};

/// Describes the flaws of a mesh, one line each: triangles that cross each other, angles below 5 degrees, places nearer
/// to the body than the comfort offset.  Empty if there are none.
std::vector<std::string> flawsOf(const MeshQuality& quality);

/// Measures the mesh.  `offsets` is the comfort offset of each vertex, m.
MeshQuality meshQuality(const TriangleMesh& mesh, const TriangleTree& body, const std::vector<double>& offsets);

}  // namespace ease
