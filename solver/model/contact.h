// Contact of the cloth with whatever it may touch, as the solver sees it: planes that samples of the cloth stay above.
//
// Samples are the vertices, the midpoints of the edges and the centroids of the triangles, in this order, each where
// its index in the mesh says: n + e + m of them.  Vertices alone would let edges slip through an arm unseen.
#pragma once

#include <algorithm>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// A sample at x may not go below normal . x = offset (m).  Zero normal and offset -1: nothing near.
struct ContactPlane {
  Vec3 normal = Vec3::Zero();
  double offset = -1.0;
  double give = 1e-3;  // depth at which the pressure has trebled, m (contact energy)
  /// How far x is below, m.
  double depth(const Vec3& x) const { return std::max(0.0, offset - normal.dot(x)); }
};

/// One plane a sample, in the samples' order, and second planes of the few that lie between two parts of the body.
struct Contacts {
  struct Second {
    int sample;
    ContactPlane plane;
  };
  std::vector<ContactPlane> planes;  // empty: no contact
  std::vector<Second> seconds;       // each sample has a first one too
};

}  // namespace ease
