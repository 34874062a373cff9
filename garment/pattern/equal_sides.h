// Both sides of every seam drawn equally long, by the smallest change of the pieces.
//
// Smoothing shortens the two sides of a seam differently, and so do the straight lines of a dart.  Every side is to be
// as long as both are in the mean; its segments v_i are stretched by one factor s, and what then keeps the outline from
// closing is shared among all segments by their lengths:
//
//   w_i = s_i v_i - |v_i| / (sum_j |v_j|) sum_j s_j v_j      minimises sum_i |w_i - s_i v_i|^2 / |v_i|, sum_i w_i = 0
//
// The factors are corrected until the lengths are met.  Edges of the garment, such as its hem, have the factor 1; the
// legs of a dart are sides of a seam.  Each piece stays where it is in the mean.
#pragma once

#include "garment/pattern/sew_line.h"

namespace ease {

/// Makes the sides of all seams equally long.  Returns how much two sides still differ at most, mm.
double makeSidesEqual(const CutGarment& cut, std::vector<SewLine>& lines);

}  // namespace ease
