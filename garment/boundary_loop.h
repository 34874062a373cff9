// Tool 1: closed loops on the body, along which the garment ends.
//
// A loop is given by points or vertices, joined in their order by shortest paths, or by a plane.  The joined paths are
// smoothed as the zero line of a function on the surface,
//
//   u_0   signed distance to the paths, m, at most +-4 s;  u = the heat equation's solution after s^2 / 2, from u_0
//   s     smoothing length, m: corners are rounded on this scale
//
// by two implicit steps, (M + h L) u' = M u, with the surface's mass matrix and Laplacian.  The zero line of u moves as
// by curvature flow for a short while (Merriman, Bence and Osher 1992), crosses edges only, and never itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "garment/edge_curve.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// A plane, and which of the lines along which it cuts a surface is meant: the one nearest to a point.
struct PlaneNear {
  Vec3 point, normal;  // m; any length
  Vec3 near;           // m
};

/// How a loop is asked for: exactly one of the three.
struct LoopRequest {
  std::string name;
  std::vector<Vec3> points;   // m
  std::vector<int> vertices;  // of the body
  std::optional<PlaneNear> plane;
};

struct BoundaryLoop {
  std::string name;
  EdgeCurve curve;  // on the body's edges
};

/// The loops, in the order of the requests.  `smoothing`: s, m.  Throws InputError naming the loop: fewer than three
/// points, a point far from the body, a vertex that the body does not have, points on parts that are not connected, a
/// loop that crosses itself or does not divide the body in two, one so small that smoothing leaves nothing, a plane
/// that cuts nothing.
std::vector<BoundaryLoop> findLoops(const TriangleMesh& body, const Topology& topology,
                                    const std::vector<LoopRequest>& requests, double smoothing);

}  // namespace ease
