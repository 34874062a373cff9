#include "collision/body/surface_relaxation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "solver/base/parallel.h"
#include "solver/mesh/topology.h"

namespace ease {
namespace {

constexpr int kPassesPerFlip = 3;
constexpr double kGlide = 0.5;  // share of the way to the middle of the neighbours that a vertex moves in a pass

double cotangent(const Positions& positions, int apex, int a, int b) {
  const Vec3 u = positions.row(a) - positions.row(apex), v = positions.row(b) - positions.row(apex);
  return u.dot(v) / u.cross(v).norm();
}

bool hasEdge(const Topology& topology, const std::array<int, 2>& vertices) {
  const auto before = [](const Edge& edge, const std::array<int, 2>& v) { return edge.vertex < v; };
  const auto found = std::lower_bound(topology.edges.begin(), topology.edges.end(), vertices, before);
  return found != topology.edges.end() && found->vertex == vertices;
}

/// Flips edges that are not Delaunay, each triangle at most once.
///
///        c                c
///      / | \            /   \          (a, b, c), (b, a, d)  becomes  (a, d, c), (d, b, c)
///     a--+--b    ->    a     b
///      \ | /            \   /
///        d                d
void flipToDelaunay(TriangleMesh& mesh, const Topology& topology) {
  std::vector<bool> changed(mesh.triangles.rows(), false);
  std::set<std::array<int, 2>> created;
  for (const Edge& edge : topology.edges) {
    if (edge.isBoundary() || changed[edge.triangle[0]] || changed[edge.triangle[1]]) continue;
    const auto [a, b] = edge.vertex;
    const auto [c, d] = edge.opposite;
    constexpr double kSlack = 1e-6;  // leaves rectangles alone: both of their diagonals are Delaunay
    if (cotangent(mesh.positions, c, a, b) + cotangent(mesh.positions, d, a, b) >= -kSlack) continue;
    const std::array<int, 2> diagonal = {std::min(c, d), std::max(c, d)};
    if (hasEdge(topology, diagonal) || !created.insert(diagonal).second) continue;
    mesh.triangles.row(edge.triangle[0]) << a, d, c;
    mesh.triangles.row(edge.triangle[1]) << d, b, c;
    changed[edge.triangle[0]] = changed[edge.triangle[1]] = true;
  }
}

/// Lists the neighbours of every inner vertex; boundary vertices get an empty list.
std::vector<std::vector<int>> innerNeighbours(const Topology& topology, int vertices) {
  std::vector<std::vector<int>> neighbours = vertexNeighbours(topology, vertices);
  for (const std::vector<int>& loop : topology.boundary_loops)
    for (int v : loop) neighbours[v].clear();
  return neighbours;
}

}  // namespace

Vec3 ontoSurface(const DistanceField& field, const Vec3& x) {
  Vec3 y = x;
  for (int i = 0; i < 4; ++i) {
    const Distance d = field(y);
    y -= d.value / d.gradient.squaredNorm() * d.gradient;
    if (std::abs(d.value) < 1e-7) break;
  }
  return y;
}

void relaxOnSurface(const DistanceField& field, int passes, TriangleMesh& mesh) {
  const int vertices = static_cast<int>(mesh.positions.rows());
  std::vector<std::vector<int>> neighbours;
  Positions moved = mesh.positions, normals = Positions::Zero(vertices, 3);
  for (int pass = 0; pass < passes; ++pass) {
    if (pass % kPassesPerFlip == 0) {
      flipToDelaunay(mesh, buildTopology(mesh, "surface"));
      neighbours = innerNeighbours(buildTopology(mesh, "surface"), vertices);
    }
    parallelFor(vertices, 256, [&](int v) {
      if (neighbours[v].empty()) return;
      Vec3 middle = Vec3::Zero();
      for (int n : neighbours[v]) middle += mesh.positions.row(n);
      const Vec3 x = mesh.positions.row(v), normal = normals.row(v);
      const Vec3 glide = kGlide * (middle / neighbours[v].size() - x);
      const Vec3 glided = x + glide - normal.dot(glide) * normal;
      // One step back to the surface is enough between passes: the error left is of second order in the glide.
      const Distance d = field(glided);
      moved.row(v) = glided - d.value / d.gradient.squaredNorm() * d.gradient;
      normals.row(v) = d.gradient.normalized();
    });
    mesh.positions = moved;
  }
  parallelFor(vertices, 256, [&](int v) {
    if (!neighbours[v].empty()) mesh.positions.row(v) = ontoSurface(field, mesh.positions.row(v));
  });
}

}  // namespace ease
