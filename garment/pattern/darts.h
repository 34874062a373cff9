// Darts: cuts from the outline into a piece that would otherwise have to stretch or shear too far.
#pragma once

#include "garment/pattern/flat_pattern.h"

namespace ease {

/// The lines, and darts where pieces are over the limits; at most settings.max_darts.
std::vector<CutLine> withDarts(const RestGarment& garment, const std::vector<CutLine>& lines,
                               const FlatSettings& settings);

}  // namespace ease
