// The garment cut along its seams into pieces, and how to glue them together again.
#pragma once

#include <vector>

#include "garment/seam.h"

namespace ease {

struct Pieces {
  TriangleMesh mesh;       // same triangles in the same order; vertices on seams once for each side
  std::vector<int> glue;   // of every vertex, the one of the whole garment that it is
  std::vector<int> piece;  // of every triangle, counted from 0 in the order of their first triangles
  int count = 0;
};

/// Cuts along the seams.  A seam that ends within the garment is a slit there.
Pieces cutIntoPieces(const TriangleMesh& garment, const std::vector<Seam>& seams);

}  // namespace ease
