// How far cloth cut as a flat piece must stretch and shear to take the shape that it is to have at rest.
//
//   G_t = F_t^-1    2x2, from the plane to the rest triangle; its columns are where warp and weft threads of the flat
//                   piece go, as long as they become
//   stretch         |g_u| and |g_v|, 1 where a thread keeps its length
//   shear           by how much the angle between the threads differs from a right one, rad
#pragma once

#include "garment/pattern/flat_start.h"

namespace ease {

struct ThreadStrain {
  double warp = 1.0, weft = 1.0;  // stretch along the threads
  double shear = 0.0;             // rad, signed
  /// The larger deviation of a thread's length from what it is on the paper.
  double worst() const { return std::max(std::abs(warp - 1.0), std::abs(weft - 1.0)); }
};

/// Strain of every triangle; a flipped triangle has the strain of its mirror image.
std::vector<ThreadStrain> threadStrains(const FlatPieces& pieces, const Positions& x);

/// Strain of a piece, weighted by area.
struct StrainSummary {
  double thread_mean = 0.0, thread_p98 = 0.0;  // of ThreadStrain::worst()
  double thread_over_share = 0.0;              // of the area, where it is above the limit
  double shear_p99 = 0.0;                      // rad
  double area = 0.0;                           // m^2, of the triangles at rest
  int flipped = 0;                             // triangles
};

/// Limits up to which a piece counts as flat enough.
struct StrainLimits {
  double thread = 0.05;                     // stretch along warp and weft
  double shear = 14.0 / 57.29577951308232;  // rad
  double share = 0.98;  // of the area that must be within the thread limit; within that of shear, 99 % must be
};

/// Summary over the triangles with `piece_of_triangle` == piece.
StrainSummary strainOf(const FlatPieces& pieces, const Positions& x, const std::vector<ThreadStrain>& strains,
                       const std::vector<int>& piece_of_triangle, int piece, const StrainLimits& limits);

/// Whether a piece stays within the limits and has no flipped triangle.
inline bool keeps(const StrainSummary& strain, const StrainLimits& limits) {
  return strain.thread_over_share <= 1.0 - limits.share && strain.shear_p99 <= limits.shear && strain.flipped == 0;
}

}  // namespace ease
