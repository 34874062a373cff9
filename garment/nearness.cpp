#include "garment/nearness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/point_triangle.h"
#include "solver/base/error.h"

namespace ease {

double distanceTo(const TriangleMesh& mesh, const Vec3& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles.rowwise()) {
    const Vec3 a = mesh.positions.row(t[0]), b = mesh.positions.row(t[1]), c = mesh.positions.row(t[2]);
    least = std::min(least, (closestOnTriangle(x, a, b, c).point - x).squaredNorm());
  }
  return std::sqrt(least);
}

void expectNear(const TriangleMesh& mesh, const Vec3& x, double farthest, const std::string& what,
                const std::string& where) {
  const double distance = distanceTo(mesh, x);
  if (distance <= farthest) return;
  throw InputError(fmt::format("{} = [{:g}, {:g}, {:g}] is {:.2g} m from {}: expected within {:g} m", what, x.x(),
                               x.y(), x.z(), distance, where, farthest));
}

}  // namespace ease
