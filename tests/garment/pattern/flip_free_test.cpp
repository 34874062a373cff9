#include "garment/pattern/flip_free.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/shapes.h"

using namespace ease;

namespace {

FlatPieces sheetPieces(int n, double size) {
  const RestGarment sheet = restGarment(bentSheet(n, size, [](double, double) { return 0.0; }));
  const CutGarment cut = cutGarment(sheet.mesh, {}, {});
  return {cut.pieces.mesh.triangles, sheet.rest_edges, {outlineOf(cut, 0)}, static_cast<int>(cut.pieces.glue.size())};
}

}  // namespace

TEST_CASE("a folded start is flattened again without flips, and counted") {
  const FlatPieces pieces = sheetPieces(8, 0.4);
  Positions folded = conformalStart(pieces);
  folded.row(40) << 0.5, 0.5, 0.0;  // the middle vertex, outside the sheet
  REQUIRE(flippedPieces(pieces, std::vector<int>(pieces.vertices, 0), folded).size() == 1);
  WovenSettings settings;
  settings.max_iterations = 0;  // so that the fold is still there
  const Flattened flat = flatten(pieces, {}, settings, &folded);
  CHECK(flat.mended == 1);
  CHECK(flippedPieces(pieces, std::vector<int>(pieces.vertices, 0), flat.x).empty());
  CHECK(flat.energy < 1e-6 * 0.16);
}

TEST_CASE("the convex start flips nothing and has the area of the triangles at rest") {
  const FlatPieces pieces = sheetPieces(8, 0.4);
  const Positions x = convexStart(pieces);
  double area = 0.0;
  for (int t = 0; t < pieces.triangles.rows(); ++t) {
    const double twice = edgeMatrix(x, pieces.triangles, t).topRows<2>().determinant();
    CHECK(twice > 0.0);
    area += 0.5 * twice;
  }
  CHECK(area == Approx(0.16).epsilon(1e-9));
}

TEST_CASE("a turned piece is turned back to its grain") {
  const FlatPieces pieces = sheetPieces(4, 0.4);
  Positions x = conformalStart(pieces);
  std::vector<Mat2> inverse;
  for (const Mat2& d : pieces.rest_edges) inverse.push_back(d.inverse());
  turnToGrain(pieces, inverse, std::vector<int>(pieces.vertices, 0), x);
  for (int t = 0; t < pieces.triangles.rows(); ++t)
    CHECK((planeGradient(pieces, x, t, inverse[t]) - Mat2::Identity()).norm() < 1e-9);
}
