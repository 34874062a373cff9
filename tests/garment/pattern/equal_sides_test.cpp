#include "garment/pattern/equal_sides.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/shapes.h"

using namespace ease;

namespace {

/// A flat sheet with a seam down its middle, whose pieces are drawn so that the seam is longer on one of them.
struct Sheet {
  FlatPattern pattern;
  std::vector<SewLine> lines;
};

Sheet unequalSheet(double stretch) {
  Seam seam{"middle", {}, false};
  for (int j = 0; j <= 8; ++j) seam.vertices.push_back(9 * j + 4);
  FlatSettings settings = exactSettings();
  Sheet sheet{flattenGarment(restGarment(bentSheet(8, 0.4, [](double, double) { return 0.0; }), {seam}), settings), {}};
  sheet.lines = sewLines(sheet.pattern, Allowances());
  for (SewnEdge& edge : sheet.lines.front().edges)
    for (PaperPoint& point : edge.points) point.y() *= stretch;
  return sheet;
}

double closingGap(const SewLine& line) {
  double gap = 0.0;
  for (size_t i = 0; i < line.edges.size(); ++i)
    gap = std::max(gap, (line.edges[i].points.back() - line.edges[(i + 1) % line.edges.size()].points.front()).norm());
  return gap;
}

}  // namespace

TEST_CASE("sides of a seam that were drawn differently become as long as both were in the mean") {
  Sheet sheet = unequalSheet(1.02);
  const std::vector<SewLine> before = sheet.lines;
  const SeamSides& seam = sheet.pattern.seams.front();
  const std::vector<double> unequal = drawnLengths(sheet.pattern.cut, before);
  REQUIRE(std::abs(unequal[seam.left] - unequal[seam.right]) == Approx(8.0).margin(0.01));
  CHECK(makeSidesEqual(sheet.pattern.cut, sheet.lines) < 0.01);
  const std::vector<double> equal = drawnLengths(sheet.pattern.cut, sheet.lines);
  CHECK(equal[seam.left] == Approx(404.0).margin(0.01));
  CHECK(equal[seam.right] == Approx(404.0).margin(0.01));
  for (size_t p = 0; p < sheet.lines.size(); ++p) {
    CHECK(closingGap(sheet.lines[p]) < 1e-9);
    for (size_t i = 0; i < before[p].edges.size(); ++i)
      for (size_t k = 0; k < before[p].edges[i].points.size(); ++k)
        CHECK((sheet.lines[p].edges[i].points[k] - before[p].edges[i].points[k]).norm() < 4.0);
  }
}

TEST_CASE("sides that are equally long already stay where they are") {
  Sheet sheet = unequalSheet(1.0);
  const std::vector<SewLine> before = sheet.lines;
  makeSidesEqual(sheet.pattern.cut, sheet.lines);
  for (size_t p = 0; p < before.size(); ++p)
    for (size_t i = 0; i < before[p].edges.size(); ++i)
      for (size_t k = 0; k < before[p].edges[i].points.size(); ++k)
        CHECK((sheet.lines[p].edges[i].points[k] - before[p].edges[i].points[k]).norm() < 1e-3);
}
