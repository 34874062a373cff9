#include "solver/model/warp.h"

#include <algorithm>

#include "solver/base/error.h"
#include "solver/base/joined.h"

namespace ease {

namespace {

constexpr double kMinProjected = 0.02;  // length of the unit grain in a triangle's plane

Vec3 unitNormal(const TriangleMesh& mesh, int t) {
  const auto v = mesh.triangles.row(t);
  return doubleAreaNormal(mesh.positions.row(v[0]), mesh.positions.row(v[1]), mesh.positions.row(v[2])).normalized();
}

/// Turns a direction from the plane of one triangle into that of another about their common edge.
Vec3 unfolded(const Vec3& direction, const Vec3& from_normal, const Vec3& to_normal, const Vec3& edge) {
  const Vec3 from_across = from_normal.cross(edge), to_across = to_normal.cross(edge);
  return direction.dot(edge) * edge + direction.dot(from_across) * to_across;
}

}  // namespace

std::vector<Vec3> warpDirections(const TriangleMesh& mesh, const Topology& topology, const Vec3& grain) {
  const int count = static_cast<int>(mesh.triangles.rows());
  std::vector<Vec3> warp(count, Vec3::Zero());
  std::vector<int> undirected;
  for (int t = 0; t < count; ++t) {
    const Vec3 normal = unitNormal(mesh, t);
    const Vec3 projected = grain.normalized() - normal * normal.dot(grain.normalized());
    if (projected.norm() >= kMinProjected)
      warp[t] = projected.normalized();
    else
      undirected.push_back(t);
  }
  while (!undirected.empty()) {  // each round adds the triangles next to those with a direction
    std::vector<std::pair<int, Vec3>> found;
    for (const int t : undirected) {
      Vec3 sum = Vec3::Zero();
      for (int k = 0; k < 3; ++k) {
        const Edge& edge = topology.edges[topology.triangle_edges(t, k)];
        const int other = edge.triangleAcross(t);
        if (other < 0 || warp[other].isZero(0.0)) continue;
        const Vec3 along = (mesh.positions.row(edge.vertex[1]) - mesh.positions.row(edge.vertex[0])).normalized();
        sum += unfolded(warp[other], unitNormal(mesh, other), unitNormal(mesh, t), along);
      }
      if (sum.norm() > 0.1) found.emplace_back(t, sum.normalized());
    }
    if (found.empty())
      throw InputError(
          joined("grain = [", grain.x(), ", ", grain.y(), ", ", grain.z(), "]: triangle ", undirected.front(),
                 " and all triangles connected to it lie at right angles to the grain, which gives them no "
                 "warp direction: write a grain that runs along the cloth, such as grain = [",
                 std::abs(grain.x()) > 0.5 ? "0, -1, 0]" : "1, 0, 0]"));
    for (const auto& [t, direction] : found) warp[t] = direction;
    std::erase_if(undirected, [&](int t) { return !warp[t].isZero(0.0); });
  }
  return warp;
}

}  // namespace ease
