// Contact of the cloth with whatever it may touch, as the solver sees it: a plane for each sample of the cloth.
//
// Samples are the vertices, the midpoints of the edges and the centroids of the triangles, in this order, each where
// its index in the mesh says: n + e + m of them.  Vertices alone would let edges slip through an arm unseen.
#pragma once

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// The sample at x may not go below normal . x = offset (m), nor above it where the cloth is `held` between two parts
/// of the body.  Zero normal and offset -1: nothing near.
struct ContactPlane {
  Vec3 normal = Vec3::Zero();
  double offset = -1.0;
  double give = 1e-3;  // depth at which the pressure has trebled, m (contact energy)
  bool held = false;
  double gap(const Vec3& x) const { return normal.dot(x) - offset; }
  /// How far the sample is where it may not be, m; negative above a plane that holds.
  double depth(const Vec3& x) const {
    const double below = -gap(x);
    return held ? below : below > 0.0 ? below : 0.0;
  }
};

}  // namespace ease
