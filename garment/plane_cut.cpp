#include "garment/plane_cut.h"

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include "solver/mesh/numbering.h"

namespace ease {
namespace {

/// Vertices of the cut mesh: those of the uncut mesh, and new ones where edges cross the plane.
struct CutVertices {
  std::vector<Vec3> positions;
  std::vector<double> distances;                  // signed distance to the plane, m
  std::map<std::array<int, 2>, int> crossing_of;  // new vertex of each crossed edge; key: its ends, smaller first

  int crossing(int a, int b) {
    const std::array<int, 2> edge = {std::min(a, b), std::max(a, b)};
    const auto [found, is_new] = crossing_of.try_emplace(edge, static_cast<int>(positions.size()));
    if (is_new) {
      const double t = distances[edge[0]] / (distances[edge[0]] - distances[edge[1]]);
      positions.push_back((1.0 - t) * positions[edge[0]] + t * positions[edge[1]]);
      distances.push_back(0.0);
    }
    return found->second;
  }
};

/// Returns the part of a triangle behind the plane as a polygon of three or four vertices; empty if there is none.
std::vector<int> cutTriangle(const std::array<int, 3>& corners, CutVertices& vertices) {
  std::vector<int> polygon;
  bool is_behind = false;
  for (int k = 0; k < 3; ++k) {
    const int here = corners[k], next = corners[(k + 1) % 3];
    const double d = vertices.distances[here], d_next = vertices.distances[next];
    if (d <= 0.0) polygon.push_back(here);
    if (d * d_next < 0.0) polygon.push_back(vertices.crossing(here, next));
    is_behind = is_behind || d < 0.0;
  }
  if (!is_behind) polygon.clear();
  return polygon;
}

TriangleMesh withoutUnusedVertices(const std::vector<Vec3>& positions, const Triangles& triangles) {
  std::vector<int> all(triangles.rows());
  std::iota(all.begin(), all.end(), 0);
  const Numbering numbering = partNumbering(triangles, std::move(all));
  Positions used(static_cast<int>(numbering.vertices.size()), 3);
  for (int v = 0; v < used.rows(); ++v) used.row(v) = positions[numbering.vertices[v]];
  return {used, renumbered(triangles, numbering)};
}

}  // namespace

TriangleMesh cutByPlane(const TriangleMesh& mesh, const Plane& plane, double snap) {
  CutVertices vertices;
  for (Eigen::Index v = 0; v < mesh.positions.rows(); ++v) {
    const Vec3 x = mesh.positions.row(v);
    const double d = planeDistance(plane, x);
    const bool is_near = std::abs(d) < snap;
    vertices.positions.push_back(is_near ? Vec3(x - d * plane.normal) : x);
    vertices.distances.push_back(is_near ? 0.0 : d);
  }
  std::vector<int> kept;  // three vertices of each triangle
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const std::array<int, 3> corners = {mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)};
    const std::vector<int> polygon = cutTriangle(corners, vertices);
    for (size_t k = 2; k < polygon.size(); ++k) kept.insert(kept.end(), {polygon[0], polygon[k - 1], polygon[k]});
  }
  return withoutUnusedVertices(vertices.positions, Eigen::Map<const Triangles>(kept.data(), std::ssize(kept) / 3, 3));
}

}  // namespace ease
