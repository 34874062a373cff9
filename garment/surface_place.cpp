#include "garment/surface_place.h"

#include <Eigen/QR>

#include "collision/triangle_tree.h"
#include "solver/mesh/triangle_gradient.h"

namespace ease {

struct SurfacePlaces::Tree {
  TriangleTree triangles;
};

SurfacePlaces::SurfacePlaces(const TriangleMesh& mesh)
    : mesh_(mesh), tree_(new Tree{TriangleTree(mesh.positions, mesh.triangles)}) {}

SurfacePlaces::~SurfacePlaces() = default;

SurfacePlace SurfacePlaces::nearest(const Vec3& x, double reach, int hint) const {
  const ClosestPoint at = tree_->triangles.closest(x, reach, hint);
  if (at.triangle < 0) return {};
  const Vec3 origin = mesh_.positions.row(mesh_.triangles(at.triangle, 0));
  const Mat32 edges = edgeMatrix(mesh_.positions, mesh_.triangles, at.triangle);
  const Eigen::Vector2d share = edges.colPivHouseholderQr().solve(at.point - origin);
  return {at.triangle, {1.0 - share.sum(), share[0], share[1]}};
}

}  // namespace ease
