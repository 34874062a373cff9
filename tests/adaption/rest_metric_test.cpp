#include "adaption/rest_metric.h"

#include <catch2/catch.hpp>

#include "adaption/growth.h"
#include "adaption/stitch.h"
#include "tests/sheet.h"

using namespace ease;

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

TEST_CASE("a flat triangle has the lengths asked for and lies along the edges wanted, which impossible lengths give") {
  const Mat2 wanted = (Mat2() << 0.0, -1.0, 1.2, 0.1).finished();
  const Mat2 flat = flatTriangle(1.2, 1.0, 1.5, wanted);
  CHECK(flat.col(0).norm() == Approx(1.2));
  CHECK(flat.col(1).norm() == Approx(1.0));
  CHECK((flat.col(1) - flat.col(0)).norm() == Approx(1.5));
  const Mat2 map = wanted * flat.inverse();
  CHECK(map(0, 1) == Approx(map(1, 0)).margin(1e-12));  // no turn is left
  CHECK(flatTriangle(1.0, 1.0, 2.5, wanted) == wanted);
}

TEST_CASE("a metric that a flat sheet can have is embedded to the last digits that matter") {
  const TriangleMesh sheet = makeSheet(8, 8, 0.2, 0.2);
  Cloth cloth(sheet, Vec3::UnitX(), Material());
  growMetric(std::vector<Mat2>(cloth.triangleCount(), growthTensor(1.2, 1.1, Eigen::Vector2d::UnitX())), cloth);
  CHECK(metricError(cloth, cloth.restPositions()).mean > 0.05);
  Stitcher stitcher(cloth, systemOrdering(cloth.vertexCount(), cloth.triangles()));
  CHECK(metricError(cloth, stitcher.embed(cloth)).p99 < 1e-3);
}

TEST_CASE("triangles far from growth keep their edges to the last bit") {
  const TriangleMesh sheet = makeSheet(8, 8, 0.2, 0.2);
  Cloth cloth(sheet, Vec3::UnitX(), Material());
  std::vector<Mat2> growth(cloth.triangleCount(), Mat2::Identity());
  growth[0] = growthTensor(1.2, 1.0, Eigen::Vector2d::UnitX());
  growMetric(growth, cloth);
  CHECK(cloth.restEdges()[0] != cloth.first().edges[0]);
  CHECK(cloth.restEdges().back() == cloth.first().edges.back());
}
