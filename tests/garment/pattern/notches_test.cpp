#include "garment/pattern/notches.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/garment/pattern/shapes.h"

using namespace ease;

namespace {

constexpr int kCells = 20;

/// A seam around a strip that reaches from the lower edge of a sheet of 0.6 m into it, `width` cells wide.
Seam around(int width) {
  const auto at = [](int i, int j) { return (kCells + 1) * j + i; };
  const int left = 10 - width / 2, right = left + width;
  Seam seam{"slot", {}, false};
  for (int j = 0; j <= 10; ++j) seam.vertices.push_back(at(left, j));
  for (int i = left + 1; i < right; ++i) seam.vertices.push_back(at(i, 10));
  for (int j = 10; j >= 0; --j) seam.vertices.push_back(at(right, j));
  return seam;
}

std::vector<DrawnPiece> drawn(int width, double allowance) {
  const RestGarment sheet = restGarment(bentSheet(kCells, 0.6, [](double, double) { return 0.0; }), {around(width)});
  Allowances allowances;
  allowances.all = allowance;
  return drawPieces(flattenGarment(sheet, FlatSettings()), allowances);
}

double distanceTo(const std::vector<PaperPoint>& line, const PaperPoint& x) {
  double nearest = INFINITY;
  for (size_t i = 0; i < line.size(); ++i) {
    const PaperPoint &a = line[i], ab = line[(i + 1) % line.size()] - a;
    const double along = std::clamp(ab.dot(x - a) / ab.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (a + along * ab - x).norm());
  }
  return nearest;
}

}  // namespace

TEST_CASE("a seam has as many notches on both sides, at the end of its own allowance") {
  for (const int width : {2, 6}) {
    const std::vector<DrawnPiece> pieces = drawn(width, 0.035);
    REQUIRE(pieces.size() == 2);
    CHECK(pieces[0].notches.size() == pieces[1].notches.size());
    CHECK(pieces[0].notches.size() == (width == 2 ? 0 : 3));  // in a slot of 6 cm 3.5 cm from both sides leave no room
    for (const DrawnPiece& piece : pieces)
      for (const Notch& notch : piece.notches) CHECK(distanceTo(piece.sew, notch.at) == Approx(35.0).margin(1.0));
  }
}

TEST_CASE("where a seam ends on another piece is a notch, and pieces cut from one drawing meet the same notches") {
  // A sheet cut across, its lower half cut once more in the middle: the lower pieces are mirror images.
  Seam across{"across", {}, false}, down{"down", {}, false};
  for (int i = 0; i <= kCells; ++i) across.vertices.push_back((kCells + 1) * 10 + i);
  for (int j = 0; j <= 10; ++j) down.vertices.push_back((kCells + 1) * j + 10);
  const RestGarment sheet = restGarment(bentSheet(kCells, 0.6, [](double, double) { return 0.0; }), {across, down});
  const std::vector<DrawnPiece> pieces = drawPieces(flattenGarment(sheet, FlatSettings()), Allowances());
  REQUIRE(pieces.size() == 2);
  const DrawnPiece &upper = pieces[pieces[0].quantity == 1 ? 0 : 1], &lower = pieces[pieces[0].quantity == 1 ? 1 : 0];
  REQUIRE(lower.quantity == 2);
  std::vector<double> on_upper, on_lower;  // from the middle of the sheet, mm
  const double middle = 0.5 * (boundsOf(upper.sew).lower.x() + boundsOf(upper.sew).upper.x());
  for (const Notch& notch : upper.notches) on_upper.push_back(notch.at.x() - middle);
  std::sort(on_upper.begin(), on_upper.end());
  REQUIRE(on_upper.size() == 5);  // two of each seam of 30 cm, and one where the seam in the middle ends
  CHECK(on_upper[2] == Approx(0.0).margin(0.1));
  CHECK(on_upper[0] == Approx(-on_upper[4]).margin(0.1));
  CHECK(on_upper[1] == Approx(-on_upper[3]).margin(0.1));
  CHECK(on_upper[4] + on_upper[3] != Approx(300.0).margin(3.0));  // turned end for end they do not match
  const Bounds bounds = boundsOf(lower.sew);
  for (const Notch& notch : lower.notches)
    if (notch.at.y() > bounds.upper.y()) on_lower.push_back(notch.at.x());
  std::sort(on_lower.begin(), on_lower.end());
  REQUIRE(on_lower.size() == 2);
  CHECK(on_lower[1] - on_lower[0] == Approx(on_upper[4] - on_upper[3]).margin(0.1));
}

TEST_CASE("the reach along a direction ends at the first point of a line") {
  const std::vector<PaperPoint> square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  CHECK(reach({5, 5}, {1, 0}, square) == Approx(5.0));
  CHECK(reach({5, 5}, {0, -1}, square) == Approx(5.0));
  CHECK(reach({-5, 5}, {1, 0}, square) == Approx(5.0));
  CHECK(reach({-5, 5}, {-1, 0}, square) == -1.0);
}
