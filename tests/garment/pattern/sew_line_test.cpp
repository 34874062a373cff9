#include "garment/pattern/sew_line.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/garment/pattern/programs.h"
#include "tests/garment/pattern/shapes.h"

using namespace ease;

namespace {

/// Distance of a point from a line, mm.
double distanceTo(const std::vector<PaperPoint>& line, const PaperPoint& x) {
  double least = 1e9;
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const PaperPoint ab = line[i + 1] - line[i];
    const double along = std::clamp(ab.dot(x - line[i]) / ab.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (line[i] + along * ab - x).norm());
  }
  return least;
}

}  // namespace

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

TEST_CASE("curved legs of a dart that would cross are drawn straight") {
  const RestGarment bowl = restGarment(bentSheet(8, 0.4, [](double x, double y) { return 0.8 * (x * x + y * y); }),
                                       {{"dart", {4, 12, 20, 30, 39, 40}, false}});
  FlatSettings settings;
  settings.max_darts = 0;
  FlatPattern pattern = flattenGarment(bowl, settings);
  const auto legs = [&] {
    std::vector<SewnEdge> found;
    const std::vector<SewLine> lines = sewLines(pattern, Allowances());
    for (const SewnEdge& edge : lines.front().edges)
      if (edge.is_dart) found.push_back(edge);
    return found;
  };
  REQUIRE(legs().size() == 2);
  CHECK(legs().front().points.size() == 6);  // they bend, and do not cross
  const PieceEdge& leg = pattern.cut.edges[pattern.seams.front().left];
  const PieceEdge& other = pattern.cut.edges[pattern.seams.front().right];
  for (const size_t i : {2, 3})  // beyond the other leg
    pattern.x.row(leg.vertices[i]) += 1.5 * (pattern.x.row(other.vertices[5 - i]) - pattern.x.row(leg.vertices[i]));
  CHECK_FALSE(overlapsItself(pattern.cut, 0, pattern.x));
  for (const SewnEdge& drawn : legs()) CHECK(drawn.points.size() == 2);
}

TEST_CASE("darts are drawn where the triangles that are sewn again end") {
  const RestGarment bowl = restGarment(bentSheet(24, 0.5, [](double x, double y) { return 1.6 * (x * x + y * y); }));
  FlatSettings settings;
  settings.limits.thread = 0.03;
  settings.max_darts = 2;
  const FlatPattern pattern = flattenGarment(bowl, settings);
  int legs = 0;
  for (const SewLine& line : sewLines(pattern, Allowances()))
    for (size_t i = 0; i < line.edges.size(); ++i) {
      if (!line.edges[i].is_dart) continue;
      ++legs;
      const PieceEdge& edge = pattern.cut.edges[line.numbers[i]];
      const Eigen::Matrix2d axes = paperAxes(pattern, edge.piece);
      for (const int v : edge.vertices)
        CHECK(distanceTo(line.edges[i].points, axes * pattern.x.row(v).head<2>().transpose()) < 3.0);
    }
  CHECK(legs >= 2);
}
