#include "garment/pattern/outline_crossing.h"

#include <catch2/catch.hpp>

using namespace ease;

TEST_CASE("two segments cross at a share of the way along each, or not at all") {
  double s = 0.0, t = 0.0;
  REQUIRE(crossing({0, 0}, {4, 0}, {1, -1}, {1, 3}, s, t));
  CHECK(s == Approx(0.25));
  CHECK(t == Approx(0.25));
  CHECK_FALSE(crossing({0, 0}, {4, 0}, {5, -1}, {5, 3}, s, t));
  CHECK_FALSE(crossing({0, 0}, {4, 0}, {0, 1}, {4, 1}, s, t));
}

TEST_CASE("a square does not cross itself, a bow tie does, wherever its outline begins") {
  Positions x(4, 3);
  x << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  CHECK_FALSE(crossesItself({0, 1, 2, 3}, x));
  CHECK(crossesItself({0, 2, 1, 3}, x));
  CHECK(crossesItself({3, 0, 2, 1}, x));
}
