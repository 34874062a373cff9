#include "adaption/rest_metric.h"

#include <catch2/catch.hpp>

#include "adaption/growth_demand.h"
#include "adaption/stitch.h"
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

TEST_CASE("the smallest growth above two others holds both, and only just") {
  const Eigen::Vector2d diagonal = Eigen::Vector2d(1.0, 1.0).normalized();
  const Mat2 a = growthTensor(1.3, 1.0, Eigen::Vector2d::UnitX()), b = growthTensor(1.2, 1.1, diagonal);
  const Mat2 both = smallestAboveBoth(a, b);
  CHECK((both - smallestAboveBoth(b, a)).norm() < 1e-12);
  CHECK((both - both.transpose()).norm() < 1e-12);
  double nearest_a = 1.0, nearest_b = 1.0;
  for (int k = 0; k < 360; ++k) {
    const Eigen::Vector2d direction(std::cos(k * M_PI / 360.0), std::sin(k * M_PI / 360.0));
    nearest_a = std::min(nearest_a, (both * direction).norm() / (a * direction).norm() - 1.0);
    nearest_b = std::min(nearest_b, (both * direction).norm() / (b * direction).norm() - 1.0);
  }
  CHECK(nearest_a > -1e-12);
  CHECK(nearest_b > -1e-12);
  CHECK(nearest_a < 1e-4);  // it touches each of them
  CHECK(nearest_b < 1e-4);
}

TEST_CASE("a sheet pulled in two directions in turn grows to what holds both, in either order") {
  const TriangleMesh sheet = makeSheet(6, 6, 0.2, 0.2);
  const Margin margin{0.7, 0.5};
  const double limit = 0.1, goal = 1.0 + 0.5 * limit;
  std::vector<std::vector<Mat2>> rests;
  for (const bool x_first : {true, false}) {
    Cloth cloth(sheet, Vec3::UnitX(), Material());
    GrowthDemand demand(limit);
    const Positions along_x = scaled(sheet, 1.3, 0.95), along_y = scaled(sheet, 0.95, 1.2);
    demand.add(cloth, stretchOf(cloth, x_first ? along_x : along_y), margin);
    demand.add(cloth, stretchOf(cloth, x_first ? along_y : along_x), margin);
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

TEST_CASE("cloth that asks for nothing keeps its rest shape to the last bit, and so do triangles far from growth") {
  const TriangleMesh sheet = makeSheet(8, 8, 0.2, 0.2);
  Cloth cloth(sheet, Vec3::UnitX(), Material());
  GrowthDemand demand(0.1);
  demand.add(cloth, stretchOf(cloth, 1.02 * sheet.positions), {});
  CHECK_FALSE(demand.letOut(cloth));
  CHECK(cloth.restEdges() == cloth.first().edges);

  std::vector<Mat2> growth(cloth.triangleCount(), Mat2::Identity());
  growth[0] = growthTensor(1.2, 1.0, Eigen::Vector2d::UnitX());
  growMetric(growth, cloth);
  CHECK(cloth.restEdges()[0] != cloth.first().edges[0]);
  CHECK(cloth.restEdges().back() == cloth.first().edges.back());
}

TEST_CASE("neighbours agree on the length of their common edge after growth that differs from triangle to triangle") {
  const TriangleMesh sheet = makeSheet(6, 6, 0.2, 0.2);
  Cloth cloth(sheet, Vec3::UnitX(), Material());
  std::vector<Mat2> growth(cloth.triangleCount());
  for (int t = 0; t < cloth.triangleCount(); ++t)
    growth[t] = growthTensor(1.0 + 0.03 * (t % 5), 1.0, Eigen::Vector2d(std::cos(t), std::sin(t)));
  growMetric(growth, cloth);
  for (const Edge& edge : cloth.topology().edges) {
    if (edge.isBoundary()) continue;
    std::vector<double> lengths;
    for (const int t : edge.triangle) {
      Eigen::Matrix<double, 2, 3> corners;
      corners << Eigen::Vector2d::Zero(), cloth.restEdges()[t];
      std::vector<Eigen::Vector2d> ends;
      for (int a = 0; a < 3; ++a)
        if (cloth.triangles()(t, a) == edge.vertex[0] || cloth.triangles()(t, a) == edge.vertex[1])
          ends.push_back(corners.col(a));
      lengths.push_back((ends[0] - ends[1]).norm());
    }
    CHECK(lengths[0] == Approx(lengths[1]).epsilon(1e-12));
  }
}

TEST_CASE("a flat triangle has the lengths asked for and lies along the edges wanted; impossible lengths give those") {
  const Mat2 wanted = (Mat2() << 0.0, -1.0, 1.2, 0.1).finished();
  const Mat2 flat = flatTriangle(1.2, 1.0, 1.5, wanted);
  CHECK(flat.col(0).norm() == Approx(1.2));
  CHECK(flat.col(1).norm() == Approx(1.0));
  CHECK((flat.col(1) - flat.col(0)).norm() == Approx(1.5));
  const Mat2 map = wanted * flat.inverse();
  CHECK(map(0, 1) == Approx(map(1, 0)).margin(1e-12));  // no turn is left
  CHECK(flatTriangle(1.0, 1.0, 2.5, wanted) == wanted);
}

TEST_CASE("cloth that grew as far as it may asks for no more and is counted") {
  const TriangleMesh sheet = makeSheet(4, 4, 0.2, 0.2);
  Cloth cloth(sheet, Vec3::UnitX(), Material());
  GrowthDemand demand(0.1);
  for (int pass = 0; pass < 20; ++pass) {  // a load that stretches it by half, however long it is
    demand.add(cloth,
               stretchOf(cloth, scaled(sheet, 1.5 * cloth.restEdges()[0](0, 0) / cloth.first().edges[0](0, 0), 1.0)),
               {});
    if (pass == 19) CHECK(demand.fullyGrown() == cloth.triangleCount());
    demand.letOut(cloth);
  }
  CHECK(cloth.restEdges()[0](0, 0) / cloth.first().edges[0](0, 0) == Approx(kMaxGrowth).epsilon(1e-6));
}

TEST_CASE("a metric that a flat sheet can have is embedded to the last digits that matter") {
  const TriangleMesh sheet = makeSheet(8, 8, 0.2, 0.2);
  Cloth cloth(sheet, Vec3::UnitX(), Material());
  growMetric(std::vector<Mat2>(cloth.triangleCount(), growthTensor(1.2, 1.1, Eigen::Vector2d::UnitX())), cloth);
  CHECK(metricError(cloth, cloth.restPositions()).mean > 0.05);
  Stitcher stitcher(cloth, systemOrdering(cloth.vertexCount(), cloth.triangles()));
  CHECK(metricError(cloth, stitcher.embed(cloth)).p99 < 1e-3);
}

TEST_CASE("sheared, compressed cloth with slack threads is crumpled, cloth with a stretched thread is taut") {
  const double shear = 0.25;  // of FᵀF, threads unstretched: sigma_1² = 1 + shear
  const Stretch crumpled = principalStretch((Mat2() << 1.0, shear, shear, 1.0).finished());
  REQUIRE(crumpled.sigma_1 > 1.1);
  CHECK(isCrumpled(crumpled, 0.1));
  CHECK_FALSE(isCrumpled(principalStretch((Mat2() << 1.3, 0.0, 0.0, 0.8).finished()), 0.1));
  CHECK_FALSE(isCrumpled(principalStretch((Mat2() << 1.0, 0.1, 0.1, 1.0).finished()), 0.1));  // within the limit
  const StretchStatistics both = momentStatistics({crumpled, principalStretch(1.5 * Mat2::Identity())}, 0.1);
  CHECK(both.share_over_limit == 1.0);
  CHECK(both.taut_share_over_limit == 0.5);
}
