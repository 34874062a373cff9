// Pieces that are mirror images of each other, such as two sleeves: both are cut from the drawing of the first.
#pragma once

#include <vector>

#include "garment/pattern/sew_line.h"

namespace ease {

struct MirrorPieces {
  std::vector<int> image_of;  // by piece: the earlier piece whose mirror image it is; -1: none
  std::vector<int> twin;      // by edge of CutGarment::edges: the edge of the other piece that lies on it; -1: none
};

/// Compares the outlines of all pieces.  Mirror images differ by 2 mm at most, and their edges have the same
/// allowances.
MirrorPieces mirrorPieces(const std::vector<SewLine>& lines);

}  // namespace ease
