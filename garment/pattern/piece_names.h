// Names of pattern pieces: those that were given, and for the others the loop or the side of the wearer.
//
//   around one loop besides hem and neck      the loop's name: "left sleeve"
//   at a part of one, facing up or down       "left shoulder", "left underarm"
//   else                                      "front" or "back", "left side" or "right side", where most of it faces
//   several of one name     told apart by "front" or "back", "left" or "right", "upper" or "lower", else by a number
#pragma once

#include "garment/pattern/flat_pattern.h"

namespace ease {

/// Names of all pieces, no two alike; those that were given stay as they are.  Throws InputError where a given point is
/// more than 0.2 m from the garment, or two names were given to one piece.
std::vector<std::string> pieceNames(const CutGarment& cut, const TriangleMesh& garment,
                                    const std::vector<PieceName>& given);

/// Which pieces face backwards.
std::vector<char> backPieces(const CutGarment& cut, const TriangleMesh& garment);

/// Whether a flat piece's warp points up the body (+y) more than down.
bool isUpsideDown(const CutGarment& cut, const TriangleMesh& garment, const Positions& x, int piece);

}  // namespace ease
