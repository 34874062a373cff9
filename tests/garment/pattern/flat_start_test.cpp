#include "garment/pattern/flat_start.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/shapes.h"

using namespace ease;

namespace {

/// One piece that is this sheet of 9 x 9 vertices.
FlatPieces pieceOf(const TriangleMesh& sheet) {
  FlatPieces pieces{sheet.triangles, restGarment(sheet).rest_edges, {{}}, static_cast<int>(sheet.positions.rows())};
  std::vector<int>& outline = pieces.outlines.front();
  for (int k = 0; k < 8; ++k) outline.push_back(k);
  for (int k = 0; k < 8; ++k) outline.push_back(9 * k + 8);
  for (int k = 8; k > 0; --k) outline.push_back(72 + k);
  for (int k = 8; k > 0; --k) outline.push_back(9 * k);
  return pieces;
}

double areaOf(const FlatPieces& pieces, const Positions& x) {
  double area = 0.0;
  for (int t = 0; t < pieces.triangles.rows(); ++t)
    area += 0.5 * edgeMatrix(x, pieces.triangles, t).topRows<2>().determinant();
  return area;
}

}  // namespace

TEST_CASE("a flat sheet starts with the lengths that it has") {
  const TriangleMesh sheet = bentSheet(8, 0.5, [](double, double) { return 0.0; });
  const FlatPieces pieces = pieceOf(sheet);
  const Positions x = conformalStart(pieces);
  for (int t = 0; t < pieces.triangles.rows(); ++t) {
    const Mat2 flat = edgeMatrix(x, pieces.triangles, t).topRows<2>();
    CHECK((edgeLengths(flat) - edgeLengths(pieces.rest_edges[t])).cwiseAbs().maxCoeff() < 1e-9);
  }
}

TEST_CASE("a bowl starts without a flipped triangle and as large as it is, in a convex outline too") {
  const FlatPieces pieces = pieceOf(bentSheet(8, 0.5, [](double x, double y) { return 3.0 * (x * x + y * y); }));
  double rest = 0.0;
  for (const Mat2& edges : pieces.rest_edges) rest += 0.5 * edges.determinant();
  for (const Positions& x : {conformalStart(pieces), convexStart(pieces)}) {
    CHECK(areaOf(pieces, x) == Approx(rest).epsilon(1e-9));
    for (int t = 0; t < pieces.triangles.rows(); ++t)
      CHECK(edgeMatrix(x, pieces.triangles, t).topRows<2>().determinant() > 0.0);
  }
}
