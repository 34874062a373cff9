#include "garment/pattern/mirror_pieces.h"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace ease;

namespace {

/// A sew line with an edge between every two corners, numbered from `first`.
SewLine lineThrough(const std::vector<PaperPoint>& corners, int first) {
  SewLine line;
  for (size_t i = 0; i < corners.size(); ++i) {
    SewnEdge edge;
    edge.points = {corners[i], corners[(i + 1) % corners.size()]};
    edge.width = 10.0;
    line.edges.push_back(edge);
    line.numbers.push_back(first + static_cast<int>(i));
  }
  return line;
}

/// The mirror image of these corners, moved, beginning at another one; counter-clockwise.
std::vector<PaperPoint> imageOf(std::vector<PaperPoint> corners) {
  for (PaperPoint& p : corners) p = PaperPoint(300.0 - p.x(), p.y() + 20.0);
  std::reverse(corners.begin(), corners.end());
  std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  return corners;
}

}  // namespace

TEST_CASE("a piece and its mirror image are one piece, to be cut twice") {
  const std::vector<PaperPoint> corners = {{0, 0}, {120, 0}, {90, 200}, {10, 180}};
  const SewLine left = lineThrough(corners, 0), other = lineThrough({{0, 0}, {150, 0}, {150, 100}, {0, 100}}, 4),
                right = lineThrough(imageOf(corners), 8);
  const MirrorPieces mirror = mirrorPieces({left, other, right});
  CHECK(mirror.image_of == std::vector<int>{-1, -1, 0});
  const std::vector<PaperPoint> image = imageOf(corners);
  for (int e = 0; e < 4; ++e) {
    const int twin = mirror.twin[e];
    REQUIRE(twin >= 8);
    CHECK(mirror.twin[twin] == e);
    const PaperPoint along = corners[(e + 1) % 4] - corners[e];
    const PaperPoint there = image[(twin - 8 + 1) % 4] - image[twin - 8];
    CHECK((PaperPoint(-along.x(), along.y()) + there).norm() < 1e-9);  // it runs the other way round
  }
  CHECK(mirrorPieces({left, lineThrough(corners, 4)}).image_of == std::vector<int>{-1, -1});
}

TEST_CASE("mirror images with other allowances or a hem in place of a seam are two pieces") {
  const std::vector<PaperPoint> corners = {{0, 0}, {120, 0}, {90, 200}, {10, 180}};
  const SewLine left = lineThrough(corners, 0);
  SewLine wider = lineThrough(imageOf(corners), 4), hemmed = wider;
  wider.edges[2].width = 20.0;
  hemmed.edges[2].is_folded = true;
  CHECK(mirrorPieces({left, wider}).image_of == std::vector<int>{-1, -1});
  CHECK(mirrorPieces({left, hemmed}).image_of == std::vector<int>{-1, -1});
}
