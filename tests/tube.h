// A tube that several tests share.
#pragma once

#include <cmath>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// A tube of radius 1 about y from y = 0 to `height`, `around` vertices a ring: loops of `around` vertices below and
/// above.
inline TriangleMesh tube(int around, int rings, double height) {
  TriangleMesh mesh{Positions(around * rings, 3), Triangles(2 * around * (rings - 1), 3)};
  int t = 0;
  for (int r = 0; r < rings; ++r) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * M_PI * i / around;
      mesh.positions.row(r * around + i) << std::cos(angle), height * r / (rings - 1), -std::sin(angle);
      if (r + 1 == rings) continue;
      const int j = (i + 1) % around;
      mesh.triangles.row(t++) << r * around + i, r * around + j, (r + 1) * around + j;
      mesh.triangles.row(t++) << r * around + i, (r + 1) * around + j, (r + 1) * around + i;
    }
  }
  return mesh;
}

}  // namespace ease
