#include "garment/pattern/sew_line.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/programs.h"
#include "tests/garment/pattern/shapes.h"

using namespace ease;

TEST_CASE("a piece and its mirror image are one piece, to be cut twice") {
  DrawnPiece left = plainPiece("left"), other = plainPiece("other", 150.0);
  left.sew = {{0, 0}, {120, 0}, {90, 200}, {10, 180}};
  const DrawnPiece right = mirrorImage(left);
  CHECK(mirrorPieces({left, other, placed(right, false, {300.0, 20.0})}) == std::vector<int>{-1, -1, 0});
  CHECK(mirrorPieces({left, left}) == std::vector<int>{-1, -1});
}

TEST_CASE("legs of a dart are drawn straight and equally long") {
  RestGarment sheet = restGarment(bentSheet(8, 0.4, [](double x, double y) { return 0.8 * (x * x + y * y); }),
                                  {{"dart", {4, 13, 21, 31, 40}, false}});
  FlatSettings settings;
  settings.max_darts = 0;
  const FlatPattern pattern = flattenGarment(sheet, settings);
  std::vector<double> legs;
  for (const SewnEdge& edge : sewLine(pattern, 0, Allowances()).edges)
    if (edge.is_dart) {
      REQUIRE(edge.points.size() == 2);
      legs.push_back((edge.points[1] - edge.points[0]).norm());
    }
  REQUIRE(legs.size() == 2);
  CHECK(legs[0] == Approx(legs[1]).epsilon(1e-9));
}

TEST_CASE("notches on both sides of a seam lie at the same share of its length in the garment") {
  Seam middle{"middle", {}, false};
  for (int j = 0; j <= 20; ++j) middle.vertices.push_back(21 * j + 10);
  const RestGarment sheet = restGarment(bentSheet(20, 0.6, [](double, double) { return 0.0; }), {middle});
  FlatSettings settings;
  const FlatPattern pattern = flattenGarment(sheet, settings);
  const std::vector<DrawnPiece> pieces = drawPieces(pattern, Allowances());
  // Two halves that are mirror images are drawn once.
  REQUIRE(pieces.size() == 1);
  CHECK(pieces.front().quantity == 2);
  REQUIRE(pieces.front().notches.size() == 2);
  CHECK(std::abs(pieces.front().notches[0].at.y() - pieces.front().notches[1].at.y()) == Approx(200.0).margin(0.5));
}
