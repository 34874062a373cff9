// The grain of each piece turned to where its threads stretch least.
//
//   D' = R(-theta) D     rest edges in the axes of threads that are turned by theta against the garment's warp
//
// Angles are tried every 15 degrees, then 5 to either side of the best one.  A turned grain must spare a twentieth of
// the stretch and 0.05 % of length in the mean, may not bring more cloth over the limits, and the piece must fit on the
// cloth.
#pragma once

#include "garment/pattern/flat_pattern.h"

namespace ease {

/// The angle of every piece, rad, counter-clockwise seen from outside the garment; 0: the garment's grain.  `pieces`
/// must be disks.
std::vector<double> freeGrain(const RestGarment& garment, const Pieces& pieces, const FlatSettings& settings);

/// The garment with the threads of each piece turned by its angle.
RestGarment withGrain(const RestGarment& garment, const Pieces& pieces, const std::vector<double>& angle_of_piece);

}  // namespace ease
