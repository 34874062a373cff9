// Notches: cuts into the allowance that tell where two sides of a seam, or the legs of a dart, meet.
//
// A seam of 5 cm or more has one to three places with notches, double where one side is a back, at the same shares of
// its length in the garment on both sides, and alike where its pieces are mirror images of others.  Where the seam
// between two other pieces ends on a piece, such as that of the shoulder on a sleeve, there is one more.  In a narrow
// corner there may be no allowance to cut into on one of the sides: the notch then moves along the seam on both, or is
// left out on both.
#pragma once

#include "garment/pattern/flat_pattern.h"
#include "garment/pattern/mirror_pieces.h"

namespace ease {

/// Adds a notch at a point of the sew line, outwards from there; a mark on the piece where there is no allowance.  None
/// where the cut line is much further than the allowance's width, mm, as beside a corner.
void addNotch(const PaperPoint& on_sew_line, const PaperPoint& outward, double width, DrawnPiece& piece);

/// By edge of CutGarment::edges: where the notches of its seam lie, as shares of its length.  `lines` and `cuts`: sew
/// lines and cut lines of all pieces of the pattern.
std::vector<std::vector<double>> seamNotches(const FlatPattern& pattern, const std::vector<SewLine>& lines,
                                             const MirrorPieces& mirror,
                                             const std::vector<std::vector<PaperPoint>>& cuts);

/// Adds the notches of a piece's seams.
void addSeamNotches(const FlatPattern& pattern, const std::vector<SewLine>& lines,
                    const std::vector<std::vector<PaperPoint>>& cuts,
                    const std::vector<std::vector<double>>& shares_of_edge, DrawnPiece& piece);

/// Distance from a point to the closed line along a direction, mm; -1 if it does not meet the line.
double reach(const PaperPoint& from, const PaperPoint& direction, const std::vector<PaperPoint>& line);

}  // namespace ease
