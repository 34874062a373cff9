#include "garment/pattern/mirror_levels.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

TEST_CASE("mirrored levels are equal on both sides, and the left side keeps its own") {
  const RestSurface sheet = flatSheet(10, 1.0);
  const RegionLevels given = discLevels(sheet, 0.2, 0.25, 0.1);
  RegionLevels levels = given;
  MirrorLevels(sheet, 0.0, 0.05)(levels);
  for (int j = 0; j <= 10; ++j)
    for (int i = 0; i <= 5; ++i) {
      const int right = j * 11 + i, left = j * 11 + 10 - i;
      CHECK(levels.of(1)[right] == Approx(levels.of(1)[left]).margin(1e-12));
      CHECK(levels.of(1)[left] == given.of(1)[left]);
    }
}

TEST_CASE("the middle plane halves the area") {
  CHECK(middlePlane(flatSheet(10, 1.0)) == Approx(0.0).margin(0.06));
}
