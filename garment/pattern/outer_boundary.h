// The outer boundary of a closed line that may cross itself.
#pragma once

#include "garment/pattern/drawing.h"

namespace ease {

/// Follows the outside of a closed line, counter-clockwise: at every crossing it takes the turn furthest to the right.
/// What the line encloses in loops of its own stays inside.  Empty where the line's segments overlap lengthwise so that
/// its outside cannot be followed.
std::vector<PaperPoint> outerBoundary(const std::vector<PaperPoint>& line);

}  // namespace ease
