#include "garment/pattern/rest_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.h"

namespace ease {
namespace {

double angleAt(const Vec2& at, const Vec2& a, const Vec2& b) {
  const Vec2 u = a - at, v = b - at;
  return std::atan2(std::abs(u.x() * v.y() - u.y() * v.x()), u.dot(v));
}

}  // namespace

RestSurface restSurface(const TriangleMesh& mesh, const std::vector<Mat2>& rest_edges) {
  RestSurface surface{mesh, rest_edges, buildTopology(mesh, "the garment"), {}, {}, {}, {}};
  const int n = surface.vertexCount(), m = surface.triangleCount();
  surface.triangles_around.resize(n);
  surface.on_border.assign(n, 0);
  for (const std::vector<int>& loop : surface.topology.boundary_loops)
    for (const int v : loop) surface.on_border[v] = 1;
  std::vector<double> angles(3 * m), sum(n, 0.0);
  double whole = 0.0, lengths = 0.0;
  for (int t = 0; t < m; ++t) {
    surface.area.push_back(0.5 * rest_edges[t].determinant());
    if (!(surface.area.back() > 0.0))
      throw ComputationError(fmt::format("the garment cannot be cut: triangle {} has no area at rest", t));
    whole += surface.area.back();
    for (int k = 0; k < 3; ++k) {
      const Vec2 at = surface.corner(t, k), a = surface.corner(t, (k + 1) % 3), b = surface.corner(t, (k + 2) % 3);
      angles[3 * t + k] = angleAt(at, a, b);
      surface.triangles_around[mesh.triangles(t, k)].push_back(t);
      sum[mesh.triangles(t, k)] += angles[3 * t + k];
      lengths += (a - at).norm();
    }
  }
  for (int t = 0; t < m; ++t) {
    double curvature = 0.0;
    for (int k = 0; k < 3; ++k)
      if (const int v = mesh.triangles(t, k); !surface.on_border[v])
        curvature += (2.0 * M_PI - sum[v]) * angles[3 * t + k] / sum[v];
    surface.curvature.push_back(curvature / surface.area[t]);
  }
  surface.side = std::sqrt(whole);
  surface.mean_edge = lengths / std::max(1, 3 * m);
  return surface;
}

}  // namespace ease
