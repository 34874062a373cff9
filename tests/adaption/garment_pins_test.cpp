#include "adaption/garment_pins.h"

#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

TEST_CASE("a pin in space stays where its vertex was when it was pinned first") {
  const Positions x = randomPositions(5, 1), later = randomPositions(5, 2);
  const std::vector<PinnedVertices> pins = {{{3, 1}, false}};
  GarmentPins first, resumed;
  first.set(pins, {}, x, Positions(), Triangles());
  REQUIRE(first.vertices() == std::vector<int>{3, 1});
  const Pins& held = first.at(nullptr);
  CHECK(held.positions[0] == Vec3(x.row(3)));
  CHECK(held.positions[1] == Vec3(x.row(1)));
  resumed.set({{{3, 1, 4}, false}}, first.anchors(), later, Positions(), Triangles());
  const Pins& kept = resumed.at(nullptr);
  CHECK(kept.positions[0] == Vec3(x.row(3)));
  CHECK(kept.positions[2] == Vec3(later.row(4)));
}
