// What keeps flat pieces in order: their grain, and that no triangle flips.
#pragma once

#include "garment/pattern/flattening.h"

namespace ease {

/// The number of every vertex's piece.
std::vector<int> pieceOfVertex(const FlatPieces& pieces);

/// Turns every piece about its middle so that its threads follow warp and weft in the mean.
void turnToGrain(const FlatPieces& pieces, const std::vector<Mat2>& rest_inverse, const std::vector<int>& piece,
                 Positions& x);

/// Pieces with a triangle whose area in the plane is not positive, in order.
std::vector<int> flippedPieces(const FlatPieces& pieces, const std::vector<int>& piece, const Positions& x);

/// Flattens one piece from a convex start such that no triangle flips, and puts it into `x`.  First with the symmetric
/// Dirichlet energy |F|^2 + |F^-1|^2, then with the woven energy and a hundredth of that as a barrier.
void flattenWithoutFlips(const FlatPieces& pieces, const std::vector<int>& piece, int which,
                         const WovenSettings& settings, Positions& x);

}  // namespace ease
