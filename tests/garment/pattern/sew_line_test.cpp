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
  const std::vector<SewLine> lines = sewLines(pattern, Allowances());
  for (const SewnEdge& edge : lines.front().edges)
    if (edge.is_dart) {
      REQUIRE(edge.points.size() == 2);
      legs.push_back((edge.points[1] - edge.points[0]).norm());
    }
  REQUIRE(legs.size() == 2);
  CHECK(legs[0] == Approx(legs[1]).margin(2e-3));
}
