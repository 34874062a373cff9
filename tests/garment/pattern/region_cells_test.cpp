#include "garment/pattern/region_cells.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

TEST_CASE("cells of three regions fill their triangle and meet in one point") {
  Triangles one(1, 3);
  one << 0, 1, 2;
  // Level k is lowest near corner k.
  RegionLevels levels{3, {-1.0, 0.5, 0.6, 0.4, -0.9, 0.5, 0.6, 0.7, -1.1}};
  Cells cells;
  cells.find(levels, one, 0);
  REQUIRE(cells.count() == 3);
  double area = 0.0;
  for (int i = 0; i < 3; ++i) {
    REQUIRE(cells[i].points.size() == 4);
    for (size_t p = 1; p + 1 < 4; ++p) {
      const Vec3 &a = cells[i].points[0].beta, &b = cells[i].points[p].beta, &c = cells[i].points[p + 1].beta;
      area += (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
    }
  }
  CHECK(area == Approx(1.0));  // twice the area in barycentric coordinates
}

TEST_CASE("a region may lie in a triangle without holding one of its corners") {
  Triangles one(1, 3);
  one << 0, 1, 2;
  RegionLevels levels{3, {-1.0, 1.0, 1.0, 1.0, -1.0, 1.0, -0.2, -0.2, 1.5}};
  Cells cells;
  cells.find(levels, one, 0);
  REQUIRE(cells.count() == 3);
  for (const CellPoint& point : cells[2].points) CHECK(cornerAt(point) == -1);
}

TEST_CASE("equal levels everywhere belong to the first label") {
  Triangles one(1, 3);
  one << 0, 1, 2;
  Cells cells;
  cells.find({2, std::vector<double>(6, 0.0)}, one, 0);
  REQUIRE(cells.count() == 1);
  CHECK(cells[0].label == 0);
}
