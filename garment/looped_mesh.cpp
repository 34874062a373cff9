#include "garment/looped_mesh.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "garment/edge_curve.h"
#include "solver/base/error.h"
#include "solver/mesh/topology.h"

namespace ease {

size_t loopNamed(const std::vector<NamedLoop>& loops, const std::string& name, const std::string& where) {
  std::vector<std::string> names;
  for (size_t l = 0; l < loops.size(); ++l) {
    if (loops[l].name == name) return l;
    names.push_back("'" + loops[l].name + "'");
  }
  throw InputError(fmt::format("{}: expected one of {}", where, fmt::join(names, ", ")));
}

std::vector<Vec3> positionsOf(const std::vector<int>& vertices, const Positions& positions) {
  std::vector<Vec3> points;
  for (const int v : vertices) points.push_back(positions.row(v));
  return points;
}

LoopedMesh withLoopNames(TriangleMesh mesh, const LoopedMesh& before) {
  std::vector<std::vector<int>> boundary = buildTopology(mesh, "garment").boundary_loops;
  LoopedMesh result{std::move(mesh), {}};
  for (const NamedLoop& loop : before.loops) {
    const std::vector<Vec3> polygon = positionsOf(loop.vertices, before.mesh.positions);
    const auto deviation = [&](const std::vector<int>& vertices) {
      double sum = 0.0;
      for (const int v : vertices) sum += polygonDistance(polygon, true, result.mesh.positions.row(v));
      return sum / static_cast<double>(vertices.size());
    };
    const auto nearer = [&](const auto& p, const auto& q) { return deviation(p) < deviation(q); };
    const auto found = std::min_element(boundary.begin(), boundary.end(), nearer);
    if (found == boundary.end())
      throw ComputationError(fmt::format("garment: boundary '{}' was lost: too few vertices for it", loop.name));
    result.loops.push_back({loop.name, *found});
    boundary.erase(found);
  }
  return result;
}

}  // namespace ease
