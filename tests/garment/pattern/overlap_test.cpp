#include "garment/pattern/overlap.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/shapes.h"

using namespace ease;

namespace {

/// A flat strip wound up like a spring around the y axis: its ends would lie above each other in the plane.
TriangleMesh ring(double turns) {
  TriangleMesh mesh = bentSheet(24, 1.0, [](double, double) { return 0.0; });
  for (auto x : mesh.positions.rowwise()) {
    const double angle = 2.0 * M_PI * turns * x[0], radius = 0.35 + 0.2 * x[1];
    x << radius * std::sin(angle), 0.2 * x[0], radius * std::cos(angle);
  }
  return mesh;
}

FlatSettings withoutDarts() {
  FlatSettings settings;
  settings.max_darts = 0;
  return settings;
}

}  // namespace

TEST_CASE("a piece that would overlap itself in the plane is cut in two, and that is told") {
  const FlatPattern pattern = flattenGarment(restGarment(ring(1.15)), withoutDarts());
  REQUIRE(pattern.pieces.size() == 2);
  for (const FlatPiece& piece : pattern.pieces) CHECK_FALSE(piece.crosses_itself);
  REQUIRE(pattern.lines.size() == 1);
  CHECK(pattern.lines.front().kind == LineKind::opened);
  REQUIRE(pattern.warnings.size() == 1);
  CHECK(pattern.warnings.front().find("cut in two along 'opening 1'") != std::string::npos);
}

TEST_CASE("a piece that does not overlap itself is left whole") {
  CHECK(withoutOverlaps(restGarment(ring(0.8)), {}, withoutDarts()).empty());
}
