#include "garment/remesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "solver/base/error.h"

namespace ease {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

constexpr int kIterations = 4;
constexpr int kMinLoopVertices = 8;  // smallest number of vertices of a boundary loop that passes around an arm

SurfaceMesh toSurfaceMesh(const TriangleMesh& mesh) {
  SurfaceMesh surface;
  std::vector<SurfaceMesh::Vertex_index> vertices;
  for (const auto& x : mesh.positions.rowwise()) vertices.push_back(surface.add_vertex(Point(x[0], x[1], x[2])));
  for (const auto& t : mesh.triangles.rowwise()) surface.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  return surface;
}

TriangleMesh fromSurfaceMesh(SurfaceMesh& surface) {
  surface.collect_garbage();
  TriangleMesh mesh;
  mesh.positions.resize(surface.number_of_vertices(), 3);
  for (const auto v : surface.vertices()) {
    const Point& x = surface.point(v);
    mesh.positions.row(v.idx()) << x.x(), x.y(), x.z();
  }
  mesh.triangles.resize(surface.number_of_faces(), 3);
  for (const auto f : surface.faces()) {
    int corner = 0;
    for (const auto v : surface.vertices_around_face(surface.halfedge(f)))
      mesh.triangles(f.idx(), corner++) = static_cast<int>(v.idx());
  }
  return mesh;
}

/// Splits the boundary into short edges, so that thinLoop() can choose vertices almost anywhere on it.
void splitBoundary(SurfaceMesh& surface, double edge_length) {
  std::vector<SurfaceMesh::Edge_index> boundary;
  for (const auto e : surface.edges())
    if (surface.is_border(e)) boundary.push_back(e);
  processing::split_long_edges(boundary, edge_length, surface);
}

/// Thins the boundary loop that contains `start` to vertices about `edge_length` (m) apart, at least kMinLoopVertices
/// of them.  The vertices between two that stay are merged into the first of the two.
void thinLoop(SurfaceMesh& surface, SurfaceMesh::Halfedge_index start, double edge_length) {
  std::vector<SurfaceMesh::Vertex_index> loop;
  std::vector<double> place;  // position of each vertex along the loop, m
  double length = 0.0;
  for (const auto h : surface.halfedges_around_face(start)) {
    loop.push_back(surface.source(h));
    place.push_back(length);
    length += std::sqrt(CGAL::squared_distance(surface.point(surface.source(h)), surface.point(surface.target(h))));
  }
  const double step = length / std::max<double>(kMinLoopVertices, std::round(length / edge_length));

  auto kept = loop[0];
  for (size_t i = 1; i < loop.size(); ++i) {
    const bool stays = std::floor(place[i] / step) > std::floor(place[i - 1] / step);
    const auto between = surface.halfedge(kept, loop[i]);
    if (stays || !between.is_valid() || !CGAL::Euler::does_satisfy_link_condition(surface.edge(between), surface)) {
      kept = loop[i];
      continue;
    }
    const Point point = surface.point(kept);
    kept = CGAL::Euler::collapse_edge(surface.edge(between), surface);
    surface.point(kept) = point;
  }
}

}  // namespace

TriangleMesh remeshed(const TriangleMesh& mesh, double edge_length) {
  SurfaceMesh surface = toSurfaceMesh(mesh);
  splitBoundary(surface, 0.2 * edge_length);
  std::vector<SurfaceMesh::Halfedge_index> loops;
  processing::extract_boundary_cycles(surface, std::back_inserter(loops));
  for (const auto start : loops) thinLoop(surface, start, edge_length);
  processing::isotropic_remeshing(surface.faces(), edge_length, surface,
                                  processing::parameters::number_of_iterations(kIterations)
                                      .number_of_relaxation_steps(2)
                                      .protect_constraints(true));
  return fromSurfaceMesh(surface);
}

TriangleMesh remeshedTo(const TriangleMesh& mesh, int vertices, const std::string& name, const Pause& pause) {
  constexpr int kTrials = 8;  // with each of the two source meshes
  constexpr double kTolerance = 0.025;
  // An equilateral mesh has area / (sqrt(3)/2 edge^2) vertices; the remesher makes about this many times as many.
  constexpr double kSurplus = 1.22;
  const double expected = std::sqrt(kSurplus * totalArea(mesh) / (0.5 * std::sqrt(3.0) * vertices));
  // The remesher treats all edges of a regular mesh alike, so the number of vertices jumps as the edge length changes.
  // If a jump skips the number asked for, the second pass starts from a finer remeshed mesh, which is irregular.
  for (const bool from_finer : {false, true}) {
    const TriangleMesh source = from_finer ? remeshed(mesh, 0.45 * expected) : mesh;
    double edge = expected, too_short = 0.0, too_long = std::numeric_limits<double>::infinity();
    for (int trial = 0; trial < kTrials; ++trial) {
      pauseIn(pause);
      TriangleMesh result = remeshed(source, edge);
      const double ratio = static_cast<double>(result.positions.rows()) / vertices;
      if (std::abs(ratio - 1.0) <= kTolerance) return result;
      (ratio > 1.0 ? too_short : too_long) = edge;
      edge *= std::sqrt(ratio);
      if (edge <= too_short || edge >= too_long) edge = std::sqrt(too_short * too_long);
    }
  }
  throw ComputationError(fmt::format("{}: no mesh within {:.1f} % of {} vertices", name, 100.0 * kTolerance, vertices));
}

}  // namespace ease
