#include "apps/start_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "adaption/presence.h"
#include "apps/garment_file.h"
#include "apps/words.h"
#include "collision/triangle_tree.h"
#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr double kFarthestGarment = 0.5;   // m: distance between garment and body
constexpr double kDeepestGarment = 0.001;  // m inside the body: less may come from coarse meshes
constexpr double kPushable = 0.006;        // m inside the body: up to this vertices are moved out
constexpr double kLargeEdge = 0.04;        // m: of a triangle; the samples of smaller ones lie close enough
constexpr double kNearPart = 0.03;         // m: from a large triangle to the part of the body that it lies on
constexpr double kMinThickness = 0.4;      // of that part, over the longest edge
constexpr double kOutside = 5e-4;          // m: where they then lie
constexpr double kSamePlace = 1e-4;        // m
constexpr double kSameSurface = 5e-3;      // m, mean distance of a body's vertices to another mesh of it

/// Signed distance to the body of each vertex, m, limited to kFarthestGarment.
std::vector<double> distancesTo(const TriangleTree& body, const Positions& x) {
  std::vector<double> distances(x.rows());
  parallelFor(static_cast<int>(x.rows()), 64,
              [&](int v) { distances[v] = body.signedDistance(x.row(v), kFarthestGarment); });
  return distances;
}

/// Whether each vertex lies at the place of a vertex of the body.
std::vector<char> atBodyVertices(const Positions& x, const SceneInput& input, const TriangleTree& body) {
  std::vector<char> same(x.rows(), 0);
  parallelFor(static_cast<int>(x.rows()), 64, [&](int v) {
    const ClosestPoint near = body.closest(x.row(v), kSamePlace);
    if (near.triangle < 0) return;
    for (int k = 0; k < 3; ++k) {
      const int corner = input.body_triangles(near.triangle, k);
      if ((input.poses.front().row(corner) - x.row(v)).norm() <= kSamePlace) same[v] = 1;
    }
  });
  return same;
}

/// Throws where a part of the garment is the wearer: closed, or most of the body, with its vertices or its surface.
void refuseBody(const std::string& name, const SceneInput& input, const Topology& topology, const TriangleTree& body,
                const GarmentParts& parts, const std::vector<double>& distances) {
  const Positions& x = input.garment.positions;
  const std::vector<char> same = atBodyVertices(x, input, body);
  std::vector<char> open(parts.vertices.size(), 0);
  for (const Edge& edge : topology.edges)
    if (edge.isBoundary()) open[parts.of_vertex[edge.vertex[0]]] = 1;
  for (size_t p = 0; p < parts.vertices.size(); ++p) {
    double away = 0.0;
    int at_vertices = 0, inside = 0;
    for (int v = 0; v < x.rows(); ++v) {
      if (parts.of_vertex[v] != static_cast<int>(p)) continue;
      at_vertices += same[v];
      inside += distances[v] < 0.0 ? 1 : 0;
      away += std::abs(distances[v]) / parts.vertices[p];
    }
    const bool is_most_of_body = 2 * at_vertices > input.poses.front().rows();
    const bool is_copy = 2 * at_vertices > parts.vertices[p] && (!open[p] || is_most_of_body);
    const bool is_like_it = !open[p] && away < kSameSurface && 10 * inside > parts.vertices[p];
    if (!is_copy && !is_like_it) continue;
    throw InputError(
        fmt::format("{}: {} of its {} vertices are the body's: is the avatar in this file? Leave it out (part "
                    "{} of {})",
                    name, is_copy ? at_vertices : parts.vertices[p], x.rows(), p + 1, parts.vertices.size()));
  }
}

/// Moves vertices inside the body out of it, or refuses those that lie too deep.
void moveOut(const std::string& name, const Warn& warn, const TriangleTree& body, const std::vector<double>& distances,
             SceneInput& input) {
  const Positions& x = input.garment.positions;
  const auto deepest = std::min_element(distances.begin(), distances.end());
  const auto isInside = [](double distance) { return distance < -kDeepestGarment; };
  const auto inside = std::count_if(distances.begin(), distances.end(), isInside);
  if (inside == 0) return;
  const auto vertex = deepest - distances.begin();
  const std::string where = fmt::format("vertex {} deepest, {:.1f} mm, at ({:.3f}, {:.3f}, {:.3f})",
                                        fileVertex(input, static_cast<int>(vertex)), -1e3 * *deepest, x(vertex, 0),
                                        x(vertex, 1), x(vertex, 2));
  if (-*deepest > kPushable)
    throw InputError(
        fmt::format("{}: {} of {} vertices lie inside the first pose, '{}', {}: expected a garment that starts "
                    "outside the body, or up to {:g} mm inside: enlarge it there, or choose the pose that it "
                    "was made on as the first",
                    name, inside, x.rows(), input.pose_names.front(), where, 1e3 * kPushable));
  input.start = x;
  parallelFor(static_cast<int>(x.rows()), 64, [&](int v) {
    if (distances[v] >= 0.0) return;
    const ClosestPoint near = body.closestOfUnion(x.row(v), 2.0 * kPushable);
    if (near.triangle >= 0) input.start.row(v) = near.point + kOutside * near.pseudonormal.normalized();
  });
  warn(fmt::format(
      "{}: {} inside the first pose, '{}', {}: moved out before the first step; the rest shape stays as it is", name,
      counted(inside, "vertex"), input.pose_names.front(), where));
}

/// Thickness of the body at the point nearest to x, straight inwards, m; at most `most`.
double thicknessNear(const TriangleTree& body, const Vec3& x, double most) {
  constexpr double kStep = 0.002;  // m
  const ClosestPoint near = body.closest(x, most);
  if (near.triangle < 0) return most;
  const Vec3 inwards = -near.pseudonormal.normalized();
  for (double depth = kStep; depth < most; depth += kStep)
    if (body.windingNumber(near.point + depth * inwards) <= 0) return depth;
  return most;
}

/// Throws where triangles lie on parts of the body so much thinner than their edges that these would pass through
/// between the points at which contact is looked for.
void refuseLargeTriangles(const std::string& name, const TriangleTree& body, const SceneInput& input) {
  const Triangles& triangles = input.garment.triangles;
  const Positions& x = input.garment.positions;
  std::vector<double> thickness(triangles.rows(), kFarthestGarment), edges(triangles.rows(), 0.0);
  parallelFor(static_cast<int>(triangles.rows()), 64, [&](int t) {
    const Vec3 a = x.row(triangles(t, 0)), b = x.row(triangles(t, 1)), c = x.row(triangles(t, 2));
    edges[t] = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    if (edges[t] < kLargeEdge) return;
    const Vec3 centroid = (a + b + c) / 3.0;
    if (body.closest(centroid, kNearPart).triangle >= 0) thickness[t] = thicknessNear(body, centroid, edges[t]);
  });
  int count = 0, worst = 0;
  for (int t = 0; t < triangles.rows(); ++t) {
    if (thickness[t] > kMinThickness * edges[t]) continue;
    if (count++ == 0 || thickness[t] / edges[t] < thickness[worst] / edges[worst]) worst = t;
  }
  if (count == 0) return;
  const Vec3 at = x.row(triangles(worst, 0));
  throw InputError(fmt::format(
      "{}: {} too large for the part of the body that they lie on: that of vertex {} at ({:.3f}, {:.3f}, {:.3f}) has "
      "an "
      "edge of {:.2g} m, and the body is {:.2g} m thick there, so that it could pass through unseen: remesh the "
      "garment to "
      "edges of at most {:.2g} m",
      name, counted(count, "triangle") + (count == 1 ? " is" : " are"), fileVertex(input, triangles(worst, 0)), at.x(),
      at.y(), at.z(), edges[worst], thickness[worst], thickness[worst]));
}

/// Warns of holes that a single triangle would close.
void warnOfMissingTriangles(const std::string& name, const Warn& warn, const SceneInput& input,
                            const Topology& topology) {
  int holes = 0, vertex = 0;
  for (const std::vector<int>& loop : topology.boundary_loops)
    if (loop.size() == 3 && holes++ == 0) vertex = loop.front();
  if (holes == 0) return;
  const Vec3 at = input.garment.positions.row(vertex);
  warn(fmt::format("{}: {} of three edges, {} at vertex {}, ({:.3f}, {:.3f}, {:.3f}) m: is a triangle missing?", name,
                   counted(holes, "hole"), holes == 1 ? "it lies" : "the first lies", fileVertex(input, vertex), at.x(),
                   at.y(), at.z()));
}

}  // namespace

void checkStart(const std::string& name, const Warn& warn, SceneInput& input) {
  const TriangleTree body(input.poses.front(), input.body_triangles);
  const Positions& x = input.garment.positions;
  const std::vector<double> distances = distancesTo(body, x);
  const std::string& pose = input.pose_names.front();
  const auto nearest = std::min_element(distances.begin(), distances.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); });
  if (std::abs(*nearest) >= kFarthestGarment) {
    double away = std::numeric_limits<double>::infinity();
    for (int v = 0; v < x.rows(); ++v) {
      const ClosestPoint near = body.closest(x.row(v), away);
      if (near.triangle >= 0) away = near.distance;
    }
    throw InputError(
        fmt::format("{}: at least {:.3g} m away from the first pose, '{}': expected a garment on the body, at "
                    "most {:g} m away at its nearest; units or axes? metres expected, y up: [garment] unit, up",
                    name, away, pose, kFarthestGarment));
  }
  const GarmentParts parts = partsOf(input.garment);
  const Topology topology = buildTopology(input.garment, name);
  refuseBody(name, input, topology, body, parts, distances);
  moveOut(name, warn, body, distances, input);
  refuseLargeTriangles(name, body, input);
  warnOfMissingTriangles(name, warn, input, topology);
  const double offset = *std::max_element(input.offsets.begin(), input.offsets.end());
  for (size_t p = 0; p < parts.vertices.size(); ++p) {
    double near = kFarthestGarment;
    for (int v = 0; v < x.rows(); ++v)
      if (parts.of_vertex[v] == static_cast<int>(p)) near = std::min(near, std::abs(distances[v]));
    if (near <= offset + Presence::kReach) continue;
    warn(fmt::format("{}: {} begins {:.2g} m or more away from the body: it is not on it", name,
                     parts.vertices.size() == 1 ? std::string("the garment")
                                                : fmt::format("part {} of {} vertices", p + 1, parts.vertices[p]),
                     near));
  }
}

}  // namespace ease
