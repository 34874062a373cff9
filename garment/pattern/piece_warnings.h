// What a tailor should know of a flat piece before it is cut.
#pragma once

#include <string>
#include <vector>

#include "garment/pattern/flat_pattern.h"

namespace ease {

/// A sentence for every piece that overlaps itself, that is over the limits, or that is too small to be sewn: less than
/// 10 cm^2, or narrower than 1 cm in the mean.
std::vector<std::string> pieceWarnings(const FlatPattern& pattern, const StrainLimits& limits);

/// The width of every piece across its grain, m.
std::vector<double> widthsAcross(const FlatPattern& pattern);

}  // namespace ease
