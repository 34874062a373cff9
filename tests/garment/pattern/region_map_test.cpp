#include "garment/pattern/region_map.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

TEST_CASE("the parts of a divided triangle have its area together") {
  const RestSurface sheet = flatSheet(1, 1.0);
  for (const std::vector<int>& label : {std::vector<int>{0, 0, 0, 0}, {0, 1, 1, 1}, {0, 1, 2, 0}, {2, 1, 1, 0}}) {
    RegionMap map{label, std::vector<double>(sheet.topology.edges.size(), 0.3)};
    for (int t = 0; t < sheet.triangleCount(); ++t) {
      const Division division = divide(labelsOf(sheet, map, t));
      const std::array<Vec2, 7> points = pointsOf(sheet, map, t);
      double area = 0.0;
      for (int i = 0; i < division.part_count; ++i) {
        const auto [a, b, c] = division.parts[i].points;
        Mat2 edges;
        edges << points[b] - points[a], points[c] - points[a];
        CHECK(edges.determinant() > 0.0);
        area += 0.5 * edges.determinant();
      }
      CHECK(area == Approx(sheet.area[t]));
    }
  }
}

TEST_CASE("regions of one label that do not touch are different regions") {
  const RestSurface sheet = flatSheet(6, 1.0);
  RegionMap map{{}, std::vector<double>(sheet.topology.edges.size(), 0.5)};
  for (int v = 0; v < sheet.vertexCount(); ++v) map.label.push_back(std::abs(sheet.mesh.positions(v, 0)) < 0.2 ? 1 : 0);
  const Regions regions = connectedRegions(sheet, map);
  REQUIRE(regions.area.size() == 3);
  CHECK(regions.area[0] + regions.area[1] + regions.area[2] == Approx(1.0));
  CHECK(regions.of.front() != regions.of.back());
}
