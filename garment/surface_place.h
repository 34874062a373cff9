// Where points lie on a triangle mesh: the nearest triangle, and the shares of its corners.
#pragma once

#include <memory>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// A place on a triangle mesh: a triangle and the shares (barycentric weights, sum 1) of its three corners.
struct SurfacePlace {
  int triangle = -1;  // -1: none
  Vec3 share = Vec3::Zero();
};

class SurfacePlaces {
 public:
  /// The mesh must outlive this object.
  explicit SurfacePlaces(const TriangleMesh& mesh);
  ~SurfacePlaces();

  /// The place nearest to `x`, m, within `reach`, m.  `hint`: a triangle that is likely near; -1: none.
  SurfacePlace nearest(const Vec3& x, double reach, int hint = -1) const;

 private:
  struct Tree;
  const TriangleMesh& mesh_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace ease
