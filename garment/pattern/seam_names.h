// Names of seams that the program found: the pieces that they join, "back / front".
//
// Several of one name are told apart by the side of the wearer that they lie on, "back / front, left", else by a number
// from the top down.
#pragma once

#include "garment/pattern/flat_pattern.h"

namespace ease {

/// Names the garment's seams from number `first` on, no two alike and none as an earlier one.  `names`: given to
/// pieces. Throws InputError where a piece cannot be opened (makeDisks) or two names were given to one piece.
void nameFoundSeams(size_t first, const std::vector<PieceName>& names, RestGarment& garment);

}  // namespace ease
