#include "garment/extension.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "garment/edge_curve.h"
#include "solver/base/error.h"
#include "solver/mesh/topology.h"

namespace ease {
namespace {

/// Computes the mean direction that leads out of the garment across the edges of its loop.
Vec3 awayFromGarment(const LoopedMesh& garment, const std::vector<int>& loop) {
  const Topology topology = buildTopology(garment.mesh, "garment");
  std::vector<char> is_in_loop(garment.mesh.positions.rows(), 0);
  for (const int v : loop) is_in_loop[v] = 1;
  Vec3 sum = Vec3::Zero();
  for (const Edge& edge : topology.edges) {
    const auto [a, b] = edge.vertex;
    if (!edge.isBoundary() || !is_in_loop[a] || !is_in_loop[b]) continue;
    const Vec3 middle = 0.5 * (garment.mesh.positions.row(a) + garment.mesh.positions.row(b));
    sum += middle - Vec3(garment.mesh.positions.row(edge.opposite[0]));
  }
  return sum;
}

Vec3 displacement(const Extension& extension, const LoopedMesh& garment, const NamedLoop& loop, const Vec3& centre) {
  if (extension.to) return *extension.to - centre;
  const std::vector<Vec3> points = positionsOf(loop.vertices, garment.mesh.positions);
  const Vec3 area = vectorArea(points);
  const double perimeter = polygonLength(points, true);
  constexpr double kMinArea = 1e-3;  // smallest |A| of a loop with an axis, in squared perimeters; a circle has 0.08
  if (area.norm() < kMinArea * perimeter * perimeter)
    throw InputError(fmt::format(
        "extension: loop '{}' has no axis, its vector area is {:.2g} m^2: expected 'to' instead of 'length'", loop.name,
        area.norm()));
  const double towards = area.dot(awayFromGarment(garment, loop.vertices)) > 0.0 ? 1.0 : -1.0;
  return extension.length * towards * area.normalized();
}

/// Whether the garment's triangle at the loop's first edge has that edge in the loop's direction.
bool triangleGoesAlong(const TriangleMesh& mesh, const std::vector<int>& loop) {
  for (const auto& t : mesh.triangles.rowwise())
    for (int k = 0; k < 3; ++k)
      if (t[k] == loop[0] && t[(k + 1) % 3] == loop[1]) return true;
  return false;
}

}  // namespace

Vec3 centreOfMass(const std::vector<Vec3>& loop) {
  Vec3 sum = Vec3::Zero();
  for (size_t i = 0; i < loop.size(); ++i) {
    const Vec3& next = loop[(i + 1) % loop.size()];
    sum += 0.5 * (next - loop[i]).norm() * (loop[i] + next);
  }
  return sum / polygonLength(loop, true);
}

Vec3 vectorArea(const std::vector<Vec3>& loop) {
  Vec3 sum = Vec3::Zero();
  for (size_t i = 0; i < loop.size(); ++i)
    sum += 0.5 * (loop[i] - loop[0]).cross(loop[(i + 1) % loop.size()] - loop[0]);
  return sum;
}

void extend(const Extension& extension, double edge_length, LoopedMesh& garment) {
  const std::string where = fmt::format("extension: loop = '{}'", extension.loop);
  NamedLoop& loop = garment.loops[loopNamed(garment.loops, extension.loop, where)];
  const std::vector<Vec3> start = positionsOf(loop.vertices, garment.mesh.positions);
  const Vec3 centre = centreOfMass(start), move = displacement(extension, garment, loop, centre);
  const int n = static_cast<int>(start.size()), first = static_cast<int>(garment.mesh.positions.rows());
  std::vector<Vec3> end;
  double furthest = 0.0;
  for (const Vec3& p : start) {
    end.push_back(centre + move + extension.scale * (p - centre));
    furthest = std::max(furthest, (end.back() - p).norm());
  }
  const int rows = std::max(1, static_cast<int>(std::lround(furthest / edge_length)));
  const bool along = triangleGoesAlong(garment.mesh, loop.vertices);
  const Eigen::Index triangles = garment.mesh.triangles.rows();
  garment.mesh.positions.conservativeResize(first + rows * n, 3);
  garment.mesh.triangles.conservativeResize(triangles + 2 * rows * n, 3);
  const auto vertex = [&](int row, int i) { return row == 0 ? loop.vertices[i % n] : first + (row - 1) * n + i % n; };
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < n; ++i) {
      const double s = (row + 1.0) / rows;
      garment.mesh.positions.row(vertex(row + 1, i)) = (1.0 - s) * start[i] + s * end[i];
      //   c---d   next row
      //   | \ |
      //   a---b   this row; the garment below
      const int a = vertex(row, i), b = vertex(row, i + 1), c = vertex(row + 1, i), d = vertex(row + 1, i + 1);
      const Eigen::Index t = triangles + 2 * (static_cast<Eigen::Index>(row) * n + i);
      garment.mesh.triangles.row(t) << a, (along ? c : b), (along ? b : c);
      garment.mesh.triangles.row(t + 1) << b, (along ? c : d), (along ? d : c);
    }
  for (int i = 0; i < n; ++i) loop.vertices[i] = first + (rows - 1) * n + i;
}

}  // namespace ease
