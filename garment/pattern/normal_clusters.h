// Regions to begin the search for cuts with: vertices that face alike.
#pragma once

#include "garment/pattern/rest_surface.h"

namespace ease {

struct Clusters {
  std::vector<int> label;  // by vertex
  int labels = 0;
};

/// Floods from the first vertex without a region while normals differ by at most `angle`, rad, from that of the first
/// one; neighbouring regions then get different labels, at most `most` (after Sharp and Crane 2018).
Clusters normalClusters(const RestSurface& surface, double angle = M_PI / 3.0, int most = 10);

}  // namespace ease
