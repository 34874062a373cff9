// Notches: cuts into the allowance that tell where two sides of a seam, or the legs of a dart, meet.
//
// A seam has notches at thirds of its length in the garment, or one in the middle where it is short; they are double
// where one side is a back.  Both sides have them at the same shares of the length.  In a narrow corner there may be no
// allowance to cut into on one of the sides: the notch then moves along the seam on both, or is left out on both.
#pragma once

#include "garment/pattern/flat_pattern.h"
#include "garment/pattern/sew_line.h"

namespace ease {

/// Adds a notch at a point of the sew line, outwards from there; a mark on the piece where there is no allowance.
void addNotch(const PaperPoint& on_sew_line, const PaperPoint& outward, DrawnPiece& piece);

/// Adds the notches of a piece's seams.  `lines` and `cuts`: sew lines and cut lines of all pieces of the pattern.
void addSeamNotches(const FlatPattern& pattern, const std::vector<SewLine>& lines,
                    const std::vector<std::vector<PaperPoint>>& cuts, DrawnPiece& piece);

/// Distance from a point to the closed line along a direction, mm; -1 if it does not meet the line.
double reach(const PaperPoint& from, const PaperPoint& direction, const std::vector<PaperPoint>& line);

}  // namespace ease
