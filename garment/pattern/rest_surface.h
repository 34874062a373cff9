// The garment at rest as a surface that cuts are looked for on: flat triangles, their curvature and their borders.
//
//   corners of triangle t, in its plane   X_0 = 0, X_1 and X_2 the columns of its rest edges, m
//   curvature of triangle t               G_t = sum over its corners of (2 pi - Theta_v) alpha / Theta_v, over its area
//
// alpha is the corner's angle, Theta_v the sum of the angles around vertex v: the curvature of every vertex is shared
// out among the triangles around it by their angles.  Vertices on a border have none.
#pragma once

#include <vector>

#include "garment/pattern/flat_pattern.h"
#include "solver/mesh/topology.h"

namespace ease {

using Vec2 = Eigen::Vector2d;

struct RestSurface {
  TriangleMesh mesh;             // in space, m
  std::vector<Mat2> rest_edges;  // of every triangle, m; rows: warp and weft
  Topology topology;
  std::vector<double> area;                        // of every triangle, m^2
  std::vector<double> curvature;                   // G of every triangle, 1/m^2
  std::vector<char> on_border;                     // by vertex
  std::vector<std::vector<int>> triangles_around;  // by vertex
  double side = 0.0;                               // m: of a square as large as the garment
  double mean_edge = 0.0;                          // m

  int vertexCount() const { return static_cast<int>(mesh.positions.rows()); }
  int triangleCount() const { return static_cast<int>(mesh.triangles.rows()); }

  /// Corner k of triangle t in its plane, m.
  Vec2 corner(int t, int k) const { return k == 0 ? Vec2::Zero() : Vec2(rest_edges[t].col(k - 1)); }
};

/// Throws InputError where the mesh is no surface (solver/mesh/topology.h), ComputationError where a triangle has no
/// area at rest.
RestSurface restSurface(const TriangleMesh& mesh, const std::vector<Mat2>& rest_edges);

}  // namespace ease
