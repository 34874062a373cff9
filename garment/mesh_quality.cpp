#include "garment/mesh_quality.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "solver/base/parallel.h"
#include "solver/mesh/topology.h"
#include "solver/model/samples.h"

namespace ease {
namespace {

/// Computes the smallest and the largest angle of triangle t, degrees.
std::pair<double, double> extremeAngles(const TriangleMesh& mesh, int t) {
  double least = 180.0, most = 0.0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 a = mesh.positions.row(mesh.triangles(t, k));
    const Vec3 u = mesh.positions.row(mesh.triangles(t, (k + 1) % 3)).transpose() - a;
    const Vec3 v = mesh.positions.row(mesh.triangles(t, (k + 2) % 3)).transpose() - a;
    const double angle = std::atan2(u.cross(v).norm(), u.dot(v)) * 180.0 / M_PI;
    least = std::min(least, angle);
    most = std::max(most, angle);
  }
  return {least, most};
}

void measureAngles(const TriangleMesh& mesh, MeshQuality& quality) {
  quality.smallest_angle_deg = 180.0;
  int well_shaped = 0;
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const auto [least, most] = extremeAngles(mesh, t);
    quality.smallest_angle_deg = std::min(quality.smallest_angle_deg, least);
    quality.largest_angle_deg = std::max(quality.largest_angle_deg, most);
    well_shaped += least >= 20.0 ? 1 : 0;
  }
  quality.share_from_20_deg = static_cast<double>(well_shaped) / quality.triangles;
}

void measureEdges(const TriangleMesh& mesh, const Topology& topology, MeshQuality& quality) {
  quality.mean_edge_m = meanEdgeLength(topology, mesh.positions);
  quality.shortest_edge_m = 1e9;
  for (const Edge& edge : topology.edges) {
    const double length = (mesh.positions.row(edge.vertex[0]) - mesh.positions.row(edge.vertex[1])).norm();
    quality.shortest_edge_m = std::min(quality.shortest_edge_m, length);
    quality.longest_edge_m = std::max(quality.longest_edge_m, length);
  }
}

void measureDistances(const TriangleMesh& mesh, const Topology& topology, const TriangleTree& body,
                      const std::vector<double>& offsets, MeshQuality& quality) {
  constexpr double kFarthest = 0.15, kNegligible = 1e-5;  // m
  std::vector<Vec3> samples;
  const ContactSamples contact_samples(quality.vertices, topology.edges, mesh.triangles);
  contact_samples.positions(mesh.positions, samples);
  std::vector<double> distances(samples.size()), wanted;
  contact_samples.values(offsets, wanted);
  parallelFor(static_cast<int>(samples.size()), 256,
              [&](int s) { distances[s] = body.signedDistance(samples[s], kFarthest); });
  for (size_t s = 0; s < samples.size(); ++s) quality.too_near += distances[s] < wanted[s] - kNegligible ? 1 : 0;
  const auto edges = distances.begin() + quality.vertices;
  const auto triangles = edges + static_cast<long>(topology.edges.size());
  quality.vertex_distance_m = *std::min_element(distances.begin(), edges);
  quality.midpoint_distance_m = *std::min_element(edges, triangles);
  quality.centroid_distance_m = *std::min_element(triangles, distances.end());
}

int countSelfIntersections(const TriangleMesh& mesh) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  using Surface = CGAL::Surface_mesh<Point>;
  Surface surface;
  std::vector<Surface::Vertex_index> vertices;
  for (const auto& x : mesh.positions.rowwise()) vertices.push_back(surface.add_vertex(Point(x[0], x[1], x[2])));
  for (const auto& t : mesh.triangles.rowwise()) surface.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  std::vector<std::pair<Surface::Face_index, Surface::Face_index>> crossing;
  CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(crossing));
  return static_cast<int>(crossing.size());
}

}  // namespace

std::vector<std::string> flawsOf(const MeshQuality& quality) {
  constexpr double kSmallestAngle = 5.0;  // degrees
  std::vector<std::string> flaws;
  if (quality.self_intersections > 0)
    flaws.push_back(fmt::format("{} pair{} of its triangles cross{} each other", quality.self_intersections,
                                quality.self_intersections == 1 ? "" : "s",
                                quality.self_intersections == 1 ? "es" : ""));
  if (quality.smallest_angle_deg < kSmallestAngle)
    flaws.push_back(fmt::format("its smallest angle has {:.2g} degrees", quality.smallest_angle_deg));
  if (quality.too_near > 0)
    flaws.push_back(fmt::format(
        "{} of its vertices, edge midpoints and centroids are nearer to the body than comfort asks for, the "
        "nearest {:.2f} mm away",
        quality.too_near, 1e3 * quality.nearest()));
  return flaws;
}

MeshQuality meshQuality(const TriangleMesh& mesh, const TriangleTree& body, const std::vector<double>& offsets) {
  MeshQuality quality;
  quality.vertices = static_cast<int>(mesh.positions.rows());
  quality.triangles = static_cast<int>(mesh.triangles.rows());
  const Topology topology = buildTopology(mesh, "garment");
  measureAngles(mesh, quality);
  measureEdges(mesh, topology, quality);
  measureDistances(mesh, topology, body, offsets, quality);
  quality.self_intersections = countSelfIntersections(mesh);
  return quality;
}

}  // namespace ease
