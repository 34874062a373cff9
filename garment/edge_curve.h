// Curves on a triangle mesh, kept as the points where they cross its edges.
//
//   point   (1 - t) x_a + t x_b on edge (a, b), a < b, 0 < t < 1
//
// Two consecutive points lie on two edges of one triangle.  So the triangles that a curve passes are known, and the
// curve moves with the mesh in every pose.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/mesh/topology.h"

namespace ease {

struct EdgePoint {
  int edge;  // index in the topology
  std::array<int, 2> vertex;
  double t;
};

struct EdgeCurve {
  std::vector<EdgePoint> points;
  bool is_closed = true;  // the first point follows the last; if false, the curve ends at both
};

/// The curve's points in a pose, m.
std::vector<Vec3> placed(const EdgeCurve& curve, const Positions& positions);

/// Length of a polygon, m.
double polygonLength(std::span<const Vec3> points, bool is_closed);

/// Distance from `x` to the polygon, m.
double polygonDistance(std::span<const Vec3> points, bool is_closed, const Vec3& x);

/// Finds the zero lines of the piecewise linear function with these values, one per vertex.  Each connected line is one
/// curve: closed, or from boundary to boundary.  Zero lines never cross each other or themselves.  A point nearer to a
/// vertex than 2 % of its edge's length is moved to that distance.
std::vector<EdgeCurve> isolines(const Topology& topology, std::span<const double> values);

}  // namespace ease
