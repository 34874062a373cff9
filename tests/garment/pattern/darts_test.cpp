#include "garment/pattern/darts.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/shapes.h"

using namespace ease;

namespace {

/// A bowl for c > 0, a saddle for c < 0.
RestGarment bent(double c) {
  return restGarment(bentSheet(24, 0.5, [c](double x, double y) { return 1.6 * (x * x + c * y * y); }));
}
const RestGarment kBowl = bent(1.0), kSaddle = bent(-1.0);

FlatSettings strict(int darts) {
  FlatSettings settings;
  settings.limits.thread = 0.03;
  settings.max_darts = darts;
  return settings;
}

}  // namespace

TEST_CASE("a bowl gets darts, which bring more of it within the limits") {
  const FlatPattern without = flattenGarment(kBowl, strict(0)), with = flattenGarment(kBowl, strict(4));
  REQUIRE_FALSE(keeps(without.pieces.front().strain, strict(0).limits));
  CHECK(with.pieces.front().darts >= 1);
  CHECK(with.pieces.front().darts <= 4);
  CHECK(with.pieces.front().strain.thread_mean < without.pieces.front().strain.thread_mean);
  for (const CutLine& line : with.lines) {
    CHECK(line.kind == LineKind::dart);
    double length = 0.0;
    const std::vector<Vec3> points = positionsOf(line.seam.vertices, kBowl.mesh.positions);
    for (size_t i = 0; i + 1 < points.size(); ++i) length += (points[i + 1] - points[i]).norm();
    CHECK(length >= 0.03);
  }
}

TEST_CASE("a saddle gets no dart, whose legs would overlap on the paper: it needs more cloth at its edge, not less") {
  const FlatPattern pattern = flattenGarment(kSaddle, strict(4));
  CHECK(pattern.pieces.front().darts == 0);
  CHECK_FALSE(pattern.pieces.front().crosses_itself);
  CHECK(pattern.warnings.size() == 1);
}

TEST_CASE("a piece that is over the limits without darts is said to be") {
  const FlatPattern pattern = flattenGarment(kSaddle, strict(0));
  REQUIRE(pattern.warnings.size() == 1);
  CHECK(pattern.warnings.front().find("no dart that was tried reaches the limits") != std::string::npos);
}

TEST_CASE("a piece that lies flat gets no dart") {
  const RestGarment flat = restGarment(bentSheet(8, 0.5, [](double, double) { return 0.0; }));
  CHECK(withDarts(flat, {}, strict(4)).empty());
}
