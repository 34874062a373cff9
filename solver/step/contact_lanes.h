// Eight contact samples side by side: what they are made of, and how deep they are.
#pragma once

#include "solver/energy/lanes.h"
#include "solver/model/cloth.h"
#include "solver/model/contact.h"

namespace ease {

/// Positions of eight vertices, side by side.
inline void gather(const Positions& x, const int (&vertices)[kLanes], Column<Lanes>& out) {
  for (int l = 0; l < kLanes; ++l) {
    const double* position = x.data() + 3 * vertices[l];
    out.x[l] = position[0];
    out.y[l] = position[1];
    out.z[l] = position[2];
  }
}

struct ContactLanes {
  int sample[kLanes];  // -1 beyond the last
  int corners[3][kLanes];
  Lanes weights[3];  // of the corners in the sample: 1; 1/2, 1/2; 1/3, 1/3, 1/3
  Lanes normal[3];
  Lanes offset, give;  // m
  Lanes area;          // m^2 that the sample stands for

  /// No samples.
  ContactLanes();
  void set(int lane, const Cloth& cloth, int sample_of_cloth, const ContactPlane& plane);

  /// m, 0 above.
  Lanes depth(const Positions& x) const;
};

}  // namespace ease
