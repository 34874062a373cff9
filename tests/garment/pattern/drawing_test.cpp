#include "garment/pattern/drawing.h"

#include <catch2/catch.hpp>

using namespace ease;

namespace {

DrawnPiece triangle() {
  DrawnPiece piece;
  piece.sew = piece.cut = {{0, 0}, {40, 0}, {0, 30}};
  piece.notches = {{{20, 0}, {0, 1}, 5.0}};
  piece.texts = {{{10, 10}, 4.0, 30.0, "front"}};
  return piece;
}

}  // namespace

TEST_CASE("the area within a line is positive counter-clockwise, and its bounds are those of its points") {
  const std::vector<PaperPoint> line = triangle().sew;
  CHECK(areaWithin(line) == Approx(600.0));
  CHECK(areaWithin({line.rbegin(), line.rend()}) == Approx(-600.0));
  CHECK(boundsOf(line).lower == PaperPoint(0, 0));
  CHECK(boundsOf(line).upper == PaperPoint(40, 30));
}

TEST_CASE("a mirror image runs counter-clockwise too, and has the same corners") {
  const DrawnPiece image = mirrorImage(triangle());
  CHECK(areaWithin(image.sew) == Approx(600.0));
  CHECK(boundsOf(image.sew).lower == PaperPoint(-40, 0));
  for (size_t i = 0; i < 3; ++i)
    CHECK(image.sew[i] == PaperPoint(-triangle().sew[2 - i].x(), triangle().sew[2 - i].y()));
  CHECK(image.notches.front().at == PaperPoint(-20, 0));
  CHECK(image.texts.front().angle == -30.0);
}

TEST_CASE("a piece turned by half a turn is moved afterwards, and its axes with it") {
  DrawnPiece piece = triangle();
  piece.axes << 1000, 0, 0, 1000;
  const DrawnPiece turned = placed(piece, true, {100, 50});
  CHECK(turned.sew[1] == PaperPoint(60, 50));
  CHECK(turned.notches.front().inward == PaperPoint(0, -1));
  CHECK(PaperPoint(turned.axes * Eigen::Vector2d(0.04, 0.0) + turned.origin) == PaperPoint(60, 50));
  CHECK(placed(piece, false, {1, 2}).texts.front().at == PaperPoint(11, 12));
}
