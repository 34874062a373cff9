#include "garment/edge_curve.h"

#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

namespace {

const TriangleMesh kSheet = makeSheet(10, 10, 1.0, 1.0, 0.2);

std::vector<double> valuesOf(const std::function<double(const Vec3&)>& f) {
  std::vector<double> values;
  for (int v = 0; v < kSheet.positions.rows(); ++v) values.push_back(f(kSheet.positions.row(v)));
  return values;
}

}  // namespace

TEST_CASE("length of and distance to a polygon, open and closed") {
  const std::vector<Vec3> corner = {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}};
  CHECK(polygonLength(corner, false) == Approx(7.0));
  CHECK(polygonLength(corner, true) == Approx(12.0));
  CHECK(polygonDistance(corner, false, {0, 4, 0}) == Approx(3.0));
  CHECK(polygonDistance(corner, true, {0, 4, 0}) == Approx(2.4));
  CHECK(polygonDistance(corner, false, {-3, 0, 4}) == Approx(5.0));
}

TEST_CASE(
    "a straight isoline runs from boundary to boundary, a round one is closed, and they lie where the function is "
    "zero") {
  const Topology topology = buildTopology(kSheet, "sheet");
  const auto lines = isolines(topology, valuesOf([](const Vec3& x) { return x.x() + 0.5 * x.y() - 0.6; }));
  REQUIRE(lines.size() == 1);
  CHECK_FALSE(lines[0].is_closed);
  CHECK(polygonLength(placed(lines[0], kSheet.positions), false) == Approx(std::hypot(1.0, 0.5)).epsilon(1e-2));
  const auto rings = isolines(topology, valuesOf([](const Vec3& x) { return (x - Vec3(0.5, 0.5, 0)).norm() - 0.3; }));
  REQUIRE(rings.size() == 1);
  CHECK(rings[0].is_closed);
  for (const Vec3& x : placed(rings[0], kSheet.positions))
    CHECK((x - Vec3(0.5, 0.5, 0.0)).norm() == Approx(0.3).margin(0.02));
}

TEST_CASE("points that follow each other on a curve lie on two edges of one triangle") {
  const Topology topology = buildTopology(kSheet, "sheet");
  const auto rings = isolines(topology, valuesOf([](const Vec3& x) { return (x - Vec3(0.5, 0.5, 0)).norm() - 0.3; }));
  REQUIRE(rings.size() == 1);
  const std::vector<EdgePoint>& points = rings[0].points;
  for (size_t i = 0; i < points.size(); ++i) {
    const Edge& p = topology.edges[points[i].edge];
    const Edge& q = topology.edges[points[(i + 1) % points.size()].edge];
    bool shared = false;
    for (const int s : p.triangle)
      for (const int t : q.triangle) shared |= s >= 0 && s == t;
    CHECK(shared);
  }
}
