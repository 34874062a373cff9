#include "garment/pattern/outer_boundary.h"

#include <catch2/catch.hpp>

using namespace ease;

TEST_CASE("a line that does not cross itself is its own outer boundary") {
  const std::vector<PaperPoint> square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  CHECK(areaWithin(outerBoundary(square)) == Approx(100.0));
}

TEST_CASE("a loop inwards is left out, a loop outwards is kept") {
  // The way to (12, 5) crosses itself beyond the square's side: the loop there belongs to the outside.
  const std::vector<PaperPoint> out = {{0, 0}, {10, 0}, {10, 4}, {14, 8}, {14, 2}, {10, 6}, {10, 10}, {0, 10}};
  CHECK(areaWithin(outerBoundary(out)) == Approx(100.0 + 0.5 * 6.0 * 3.0 - 1.0 + 0.0).margin(2.0));
  const std::vector<PaperPoint> in = {{0, 0}, {10, 0}, {10, 6}, {6, 2}, {6, 8}, {10.5, 4}, {10, 10}, {0, 10}};
  CHECK(areaWithin(outerBoundary(in)) == Approx(100.0).margin(3.0));
}
