// Contact of the cloth as the solver sees it: planes above which the samples of the cloth (samples.h) must stay.
#pragma once

#include <algorithm>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// A sample at x must satisfy normal . x >= offset (m).  A zero normal with offset -1 means that nothing is near.
struct ContactPlane {
  Vec3 normal = Vec3::Zero();
  double offset = -1.0;
  double give = 1e-3;  // m: depth at which the pressure is three times that of a linear spring (energy/contact.h)
  /// Depth of x below the plane, m; 0 above it.
  double depth(const Vec3& x) const { return std::max(0.0, offset - normal.dot(x)); }
};

/// One plane per sample, in the order of the samples, and further planes of the few samples that lie between two parts
/// of the body: one of the other part, and those that a time step keeps from its earlier rounds (time_step.h).
struct Contacts {
  struct Second {
    int sample;
    ContactPlane plane;
    bool rubs = true;  // whether friction acts on it; at most one for each sample
  };
  std::vector<ContactPlane> planes;  // empty: no contact
  std::vector<Second> seconds;       // `planes` holds the first plane of each of these samples
  // Displacement over the step, m, of the point that is fixed to the body's surface and ends where the sample was
  // looked up: for each of `planes`, then for each of `seconds` that rubs, which come first there. Only friction reads
  // it; empty: nothing moves.
  std::vector<Vec3> motions;
};

}  // namespace ease
