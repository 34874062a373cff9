// Darts: cuts from the outline into a piece that would otherwise have to stretch or shear too far.
//
// Pieces are taken one by one.  While a piece is over the limits, the shortest ways from its outline to some tips
// spread over it are tried, then to tips around the best one, each by flattening the piece anew from where it is.  The
// one is kept that gains most, in area over a limit and in energy, for its length and the effort of sewing one more.  A
// dart whose legs would overlap on the paper, as where a piece needs more cloth and not less, does not count.  The
// search ends where no dart gains a fourteenth of what is left.  The mirror image of a dart on the wearer's other side
// is tried as well, and taken instead of a dart that begins and ends within 2 cm of it.  The two legs of a dart are
// sewn together and flattened equally long.
#pragma once

#include "garment/pattern/flat_pattern.h"

namespace ease {

/// The lines, and darts where pieces are over the limits; at most settings.max_darts with those that are there.
std::vector<CutLine> withDarts(const RestGarment& garment, const std::vector<CutLine>& lines,
                               const FlatSettings& settings);

}  // namespace ease
