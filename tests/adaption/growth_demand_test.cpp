#include "adaption/growth_demand.h"

#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

namespace {

std::vector<Stretch> stretchOf(const Cloth& cloth, const Positions& x) {
  std::vector<Stretch> stretch;
  measureStretch(cloth, x, stretch);
  return stretch;
}

/// The sheet scaled along its two directions.
Positions scaled(const TriangleMesh& sheet, double along_x, double along_y) {
  Positions x = sheet.positions;
  x.col(0) *= along_x;
  x.col(1) *= along_y;
  return x;
}

}  // namespace

TEST_CASE("a sheet pulled in two directions in turn grows to what holds both, in either order") {
  const TriangleMesh sheet = makeSheet(6, 6, 0.2, 0.2);
  const double limit = 0.1, goal = 1.0 + kGoal * limit;
  std::vector<std::vector<Mat2>> rests;
  for (const bool x_first : {true, false}) {
    Cloth cloth(sheet, Vec3::UnitX(), Material());
    GrowthDemand demand(limit);
    const Positions along_x = scaled(sheet, 1.3, 0.95), along_y = scaled(sheet, 0.95, 1.2);
    demand.add(cloth, stretchOf(cloth, x_first ? along_x : along_y));
    demand.add(cloth, stretchOf(cloth, x_first ? along_y : along_x));
    REQUIRE(demand.letOut(cloth));
    for (int t = 0; t < cloth.triangleCount(); ++t) {
      const Mat2 map = cloth.restEdges()[t] * cloth.first().edges[t].inverse();
      CHECK(map(0, 0) == Approx(1.3 / goal).epsilon(1e-9));
      CHECK(map(1, 1) == Approx(1.2 / goal).epsilon(1e-9));
      CHECK(std::abs(map(0, 1)) < 1e-9);
    }
    rests.push_back(cloth.restEdges());
  }
  for (size_t t = 0; t < rests[0].size(); ++t) CHECK((rests[0][t] - rests[1][t]).norm() < 1e-12);
}

TEST_CASE("cloth grows to the strain that is its goal") {
  const TriangleMesh sheet = makeSheet(4, 4, 0.2, 0.2);
  Cloth cloth(sheet, Vec3::UnitX(), Material());
  GrowthDemand demand(0.1, 0.3);
  demand.add(cloth, stretchOf(cloth, scaled(sheet, 1.2, 1.0)));
  REQUIRE(demand.letOut(cloth));
  for (int t = 0; t < cloth.triangleCount(); ++t) {
    const Mat2 map = cloth.restEdges()[t] * cloth.first().edges[t].inverse();
    CHECK(map(0, 0) == Approx(1.2 / 1.03).epsilon(1e-9));
  }
}

TEST_CASE("cloth that asks for nothing keeps its rest shape to the last bit") {
  const TriangleMesh sheet = makeSheet(8, 8, 0.2, 0.2);
  Cloth cloth(sheet, Vec3::UnitX(), Material());
  GrowthDemand demand(0.1);
  demand.add(cloth, stretchOf(cloth, 1.02 * sheet.positions));
  CHECK_FALSE(demand.letOut(cloth));
  CHECK(cloth.restEdges() == cloth.first().edges);
}

TEST_CASE("cloth that grew as far as it may asks for no more and is counted") {
  const TriangleMesh sheet = makeSheet(4, 4, 0.2, 0.2);
  Cloth cloth(sheet, Vec3::UnitX(), Material());
  GrowthDemand demand(0.1);
  for (int pass = 0; pass < 20; ++pass) {  // a load that stretches it by half, however long it is
    demand.add(cloth,
               stretchOf(cloth, scaled(sheet, 1.5 * cloth.restEdges()[0](0, 0) / cloth.first().edges[0](0, 0), 1.0)));
    if (pass == 19) CHECK(demand.fullyGrown() == cloth.triangleCount());
    demand.letOut(cloth);
  }
  CHECK(cloth.restEdges()[0](0, 0) / cloth.first().edges[0](0, 0) == Approx(kMaxGrowth).epsilon(1e-6));
}
