#include "garment/pattern/layout.h"

#include <catch2/catch.hpp>

#include "solver/base/error.h"
#include "tests/garment/pattern/programs.h"

using namespace ease;

namespace {

bool overlap(const Bounds& a, const Bounds& b, double gap) {
  return (a.lower.array() < b.upper.array() + gap - 1e-9).all() &&
         (b.lower.array() < a.upper.array() + gap - 1e-9).all();
}

}  // namespace

TEST_CASE("pieces lie on the cloth beside each other, with the gap between them") {
  std::vector<DrawnPiece> pieces;
  for (int k = 0; k < 5; ++k) pieces.push_back(plainPiece("p", 150.0 + 40.0 * k, 300.0 - 30.0 * k));
  const Layout layout = layOut(pieces, 800.0, 10.0);
  REQUIRE(layout.placements.size() == 5);
  std::vector<Bounds> bounds;
  for (const Placement& placement : layout.placements)
    bounds.push_back(boundsOf(placed(pieces[placement.piece], placement.is_turned, placement.by).cut));
  for (size_t i = 0; i < bounds.size(); ++i) {
    CHECK(bounds[i].lower.minCoeff() >= 0.0);
    CHECK(bounds[i].upper.x() <= 800.0);
    CHECK(bounds[i].upper.y() <= layout.length);
    for (size_t j = i + 1; j < bounds.size(); ++j) CHECK_FALSE(overlap(bounds[i], bounds[j], 9.0));
  }
}

TEST_CASE("a piece wider than the cloth is refused with its width") {
  CHECK_THROWS_WITH(layOut({plainPiece("front", 1500.0, 100.0)}, 1400.0, 10.0),
                    Catch::Contains("piece 'front' is 1.520 m wide") && Catch::Contains("fabric_width = 1.4:"));
  CHECK_NOTHROW(layOut({plainPiece("front", 1380.0, 100.0)}, 1400.0, 10.0));  // with 2 cm of allowance just as wide
  CHECK_THROWS_AS(layOut({plainPiece("front", 1380.1, 100.0)}, 1400.0, 10.0), InputError);
}

TEST_CASE("triangles nest head to tail") {
  DrawnPiece triangle = plainPiece("t");
  triangle.cut = triangle.sew = {{0, 0}, {400, 0}, {0, 400}};
  CHECK(layOut({triangle, triangle}, 460.0, 4.0).length < 620.0);
}
