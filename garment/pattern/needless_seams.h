// Seams that are not needed: where the pieces on both sides are flat enough as one piece, within the limits of woven
// cloth.
//
// All chains between two pieces are tried, each by flattening the piece that both become without it (opened along the
// shortest way where that is no disk), and the one is removed whose energy rises least for the length that is saved;
// then all are tried again.  A union counts if it lies flat without flips and without crossing itself, its threads keep
// three fifths of the limit on 99 % of its area (the whole limit is for what nothing else can mend), it is not wider
// than the cloth, and the rectangle around it is at most a quarter larger than those around both pieces: what winds
// around the body in one piece wastes cloth.  Pieces that are too small or too narrow to sew come first, and may also
// join a neighbour with which they keep the pattern's own limits, or are no further over the strict ones than before.
#pragma once

#include <optional>

#include "garment/pattern/piece_trial.h"

namespace ease {

/// The garment's seams without needless ones; the first `kept` stay in any case.  `mirror`: x of a plane, m, so that a
/// seam goes only together with its mirror image; none: each by itself.
std::vector<Seam> neededSeams(const RestGarment& garment, size_t kept, const FlatSettings& settings,
                              const SewableSize& size, std::optional<double> mirror = {});

}  // namespace ease
