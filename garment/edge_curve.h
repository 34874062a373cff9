// Curves on a triangle mesh, kept as the points where they cross its edges.
//
//   point   (1 - t) x_a + t x_b on edge (a, b), a < b, 0 < t < 1
//
// Two points that follow each other lie on two edges of one triangle, so that a curve knows which triangles it passes
// and goes along with the mesh into every pose.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/mesh/topology.h"

namespace ease {

struct EdgePoint {
  int edge;  // of the topology
  std::array<int, 2> vertex;
  double t;
};

struct EdgeCurve {
  std::vector<EdgePoint> points;
  bool is_closed = true;  // the last point is followed by the first; otherwise both lie on the boundary or inside
};

/// The curve's points in a pose, m.
std::vector<Vec3> placed(const EdgeCurve& curve, const Positions& positions);

/// Length of a polygon, m.
double polygonLength(std::span<const Vec3> points, bool is_closed);

/// Distance from `x` to the polygon, m.
double polygonDistance(std::span<const Vec3> points, bool is_closed, const Vec3& x);

/// Where the piecewise linear function of these values, one a vertex, is zero: every connected piece of it, closed ones
/// and those that run from boundary to boundary.  They cross each other and themselves nowhere.  Points within 2 % of
/// an edge's length of its ends are moved that far from them.
std::vector<EdgeCurve> isolines(const Topology& topology, std::span<const double> values);

}  // namespace ease
