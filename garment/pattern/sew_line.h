// The sew line of a flat piece, in millimetres as it lies on the paper.
#pragma once

#include "garment/pattern/allowance.h"
#include "garment/pattern/draw_piece.h"

namespace ease {

/// A piece's edges as they are drawn: smoothed over about three edges of the mesh, the same way on both sides of a
/// seam.  Legs of darts that bend by less than 2 mm, or would cross the line elsewhere, are straight.  Both sides of a
/// seam are equally long (equal_sides.h).
struct SewLine {
  std::vector<SewnEdge> edges;  // in the order of CutGarment::outlines
  std::vector<int> numbers;     // of CutGarment::edges
};

/// From (warp, weft), m, to the paper, mm: up on the wearer is up.
Eigen::Matrix2d paperAxes(const FlatPattern& pattern, int piece);

/// The sew lines of all pieces.
std::vector<SewLine> sewLines(const FlatPattern& pattern, const Allowances& allowances);

/// Length of every edge of the cut as it is drawn, mm.
std::vector<double> drawnLengths(const CutGarment& cut, const std::vector<SewLine>& lines);

/// The point of a drawn edge at a share of the seam's length in the garment; `direction`: along the edge there.
PaperPoint pointAt(const FlatPattern& pattern, const SewnEdge& drawn, int edge, double share, PaperPoint& direction);

}  // namespace ease
