// Pieces that overlap themselves in the plane, such as both legs of trousers cut as one, are cut in two.
//
//      \    \      /    /
//       \ left \ / right       the outline crosses itself: the piece would need the same cloth twice
//        \     / \     /
//         \  /  C  \  /        C: middle of the way along the outline between the two edges that cross
//          |        |
//          |        |          the cut leads from C to the point half way around the outline, as straight as the
//           '------'           piece's edges allow
#pragma once

#include "garment/pattern/flat_pattern.h"

namespace ease {

/// The lines, and cuts through pieces that overlap themselves even without their darts.  Pieces that cannot be mended
/// so are left as they are.
std::vector<CutLine> withoutOverlaps(const RestGarment& garment, const std::vector<CutLine>& lines,
                                     const FlatSettings& settings);

}  // namespace ease
