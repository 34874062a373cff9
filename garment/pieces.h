// The garment cut along its seams into pieces, and how to glue them together again.
#pragma once

#include <vector>

#include "garment/seam.h"

namespace ease {

struct Pieces {
  TriangleMesh mesh;       // the garment's triangles in their order; a vertex on a seam occurs once for each side
  std::vector<int> glue;   // for each vertex of the pieces, the garment's vertex that it came from
  std::vector<int> piece;  // for each triangle, the number of its piece; pieces are numbered by their first triangle
  int count = 0;
};

/// Cuts the garment along the seams.  A seam that ends inside the garment ends in a slit.
Pieces cutIntoPieces(const TriangleMesh& garment, const std::vector<Seam>& seams);

}  // namespace ease
