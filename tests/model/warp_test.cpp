#include "solver/model/warp.h"

#include <catch2/catch.hpp>

#include "solver/base/error.h"
#include "tests/sheet.h"

using namespace ease;

TEST_CASE("a triangle's warp is the grain in its plane") {
  TriangleMesh sheet = makeSheet(3, 3, 1.0, 1.0);
  sheet.positions.col(2) = sheet.positions.col(1);  // rises at 45 degrees
  for (const Vec3& warp : warpDirections(sheet, buildTopology(sheet, "a"), Vec3(0, -1, 0)))
    CHECK((warp - Vec3(0, -1, -1).normalized()).norm() < 1e-12);
}

TEST_CASE("triangles across the grain take the direction of their neighbours, unfolded") {
  TriangleMesh bent = makeSheet(2, 4, 0.2, 0.4);
  for (int v = 0; v < bent.positions.rows(); ++v)  // the upper half is folded level
    if (const double y = bent.positions(v, 1); y > 0.2) bent.positions.row(v) << bent.positions(v, 0), 0.2, y - 0.2;
  const std::vector<Vec3> warp = warpDirections(bent, buildTopology(bent, "a"), Vec3(0, -1, 0));
  for (int t = 0; t < 8; ++t) CHECK((warp[t] - Vec3(0, -1, 0)).norm() < 1e-12);
  for (int t = 8; t < 16; ++t) CHECK((warp[t] - Vec3(0, 0, -1)).norm() < 1e-12);
}

TEST_CASE("cloth that lies across the grain as a whole is refused") {
  const TriangleMesh sheet = makeSheet(2, 2, 1.0, 1.0);
  CHECK_THROWS_AS(warpDirections(sheet, buildTopology(sheet, "a"), Vec3(0, 0, 1)), InputError);
}
