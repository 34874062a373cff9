#include "garment/hole_filling.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>
#include <fmt/format.h>

#include "solver/base/error.h"

namespace ease {

std::vector<Hole> holesOf(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<Hole> holes;
  for (const std::vector<int>& loop : topology.boundary_loops) {
    Eigen::AlignedBox3d box;
    Vec3 sum = Vec3::Zero();
    for (const int v : loop) {
      box.extend(mesh.positions.row(v).transpose());
      sum += mesh.positions.row(v).transpose();
    }
    holes.push_back({loop, sum / static_cast<double>(loop.size()), box.diagonal().norm()});
  }
  return holes;
}

Triangles patchFor(const Hole& hole, const Positions& positions, const std::string& name) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  // The triangles around the hole run along its edge one way; those that close it run the other way.
  const std::vector<int> edge(hole.loop.rbegin(), hole.loop.rend());
  std::vector<Kernel::Point_3> points;
  for (const int v : edge) points.emplace_back(positions(v, 0), positions(v, 1), positions(v, 2));
  std::vector<CGAL::Triple<int, int, int>> patch;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(points, std::back_inserter(patch));
  if (patch.size() + 2 != edge.size())
    throw InputError(
        fmt::format("{}: the hole about ({:.3f}, {:.3f}, {:.3f}) cannot be closed: close it in the program "
                    "that the mesh comes from",
                    name, hole.centre.x(), hole.centre.y(), hole.centre.z()));
  Triangles triangles(static_cast<int>(patch.size()), 3);
  for (size_t t = 0; t < patch.size(); ++t)
    triangles.row(static_cast<long>(t)) << edge[patch[t].first], edge[patch[t].second], edge[patch[t].third];
  return triangles;
}

}  // namespace ease
