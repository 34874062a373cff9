// Pieces in the plane to begin the flattening with, from the lengths of their triangles alone.
//
//   conformal   minimise over (p, q)   sum_t a_t |grad q - J grad p|^2,   J a quarter turn, two vertices of every piece
//               fixed: angles change as little as possible (Levy et al. 2002, "Least squares conformal maps"); may flip
//   convex      the outline on a circle, every other vertex the mean of its neighbours (Tutte 1963): never flips
#pragma once

#include <vector>

#include "solver/mesh/topology.h"
#include "solver/mesh/triangle_gradient.h"

namespace ease {

/// Triangles in the plane with the lengths that they should have.  One or more pieces, each a disk.
struct FlatPieces {
  Triangles triangles;
  std::vector<Mat2> rest_edges;            // of every triangle, m; rows: warp and weft
  std::vector<std::vector<int>> outlines;  // vertices around every piece, counter-clockwise
  int vertices = 0;
};

/// Positions (warp, weft, 0), m: conformal, each piece as large as its triangles at rest.  Throws ComputationError
/// where the triangles are degenerate.
Positions conformalStart(const FlatPieces& pieces);

/// Positions (warp, weft, 0), m, without a flipped triangle: each piece in a circle as large as its triangles.
Positions convexStart(const FlatPieces& pieces);

/// Gradient of triangle t from its rest edges to the plane.
inline Mat2 planeGradient(const FlatPieces& pieces, const Positions& x, int t, const Mat2& rest_inverse) {
  return edgeMatrix(x, pieces.triangles, t).topRows<2>() * rest_inverse;
}

}  // namespace ease
