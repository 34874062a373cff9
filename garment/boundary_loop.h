// Tool 1: closed loops on the body, where the garment ends.
//
// A loop is given by points or vertices, which shortest paths join in their order, or by a plane.  The joined paths
// are smoothed as the zero line of a function u on the surface:
//
//   s     smoothing length, m: corners are rounded on this scale
//   u_0   signed distance to the paths, m, limited to +-4 s
//   u     solution of the heat equation at time s^2 / 2 that starts from u_0
//
// Two implicit steps compute it, (M + h L) u' = M u, with time step h, mass matrix M and Laplacian L of the surface.
// Diffusion moves the zero line approximately by curvature flow (Merriman, Bence and Osher 1992).  A zero line crosses
// edges of the mesh but never itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "garment/edge_curve.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// A plane that cuts a surface.  If it cuts along several lines, the line nearest to the point `near` is meant.
struct PlaneNear {
  Vec3 point, normal;  // m; the normal may have any length
  Vec3 near;           // m
};

/// Request for a loop: exactly one of points, vertices and plane is given.
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

/// Finds the loops, in the order of the requests.  `smoothing` is the length s, m.  Throws InputError naming the loop
/// if it has fewer than three points, a point far from the body, a vertex that the body does not have or points on
/// parts that are not connected; if it crosses itself or does not divide the body in two; if it is so small that
/// smoothing leaves nothing; or if its plane cuts nothing.
std::vector<BoundaryLoop> findLoops(const TriangleMesh& body, const Topology& topology,
                                    const std::vector<LoopRequest>& requests, double smoothing);

}  // namespace ease
