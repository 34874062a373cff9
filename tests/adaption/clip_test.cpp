#include "adaption/clip.h"

#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

namespace {

struct Stretched {
  TriangleMesh mesh = makeSheet(8, 8, 0.2, 0.2, 0.2);
  Cloth cloth{mesh, Vec3(0.0, -1.0, 0.0), Material()};
  std::vector<Stretch> stretch;
  std::vector<Mat2> growth;
  explicit Stretched(const Mat3& map) { measureStretch(cloth, mesh.positions * map.transpose(), stretch); }
};

}  // namespace

TEST_CASE("cloth within the limit, or compressed, does not grow") {
  Mat3 map = Vec3(1.05, 0.4, 1.0).asDiagonal();
  Stretched s(map);
  CHECK_FALSE(clipStretch(s.cloth, s.stretch, clipOptions(0.1), s.growth));
  for (const Mat2& G : s.growth) CHECK(G == Mat2::Identity());
}

TEST_CASE(
    "evenly stretched cloth grows just so much that its stretch becomes what is asked, along and across any "
    "direction") {
  Mat3 map;
  map << 1.3, 0.2, 0.0, 0.1, 1.25, 0.0, 0.0, 0.3, 1.0;
  Stretched s(map);
  const ClipOptions options = clipOptions(0.1);
  REQUIRE(clipStretch(s.cloth, s.stretch, options, s.growth));
  for (int t = 0; t < s.cloth.triangleCount(); ++t) {
    const Mat32 F = s.cloth.deformation(s.mesh.positions * map.transpose(), t) * s.growth[t].inverse();
    const Stretch after = principalStretch(F.transpose() * F);
    CHECK(after.sigma_1 == Approx(1.0 + options.grow_to).epsilon(1e-9));
    CHECK(after.sigma_2 == Approx(std::min(s.stretch[t].sigma_2, 1.0 + options.grow_to)).epsilon(1e-9));
  }
}

TEST_CASE("one stretched triangle shares its growth with its neighbours, and none shrinks") {
  Stretched s(Mat3::Identity());
  const int t = 60;
  s.stretch[t].sigma_1 = 1.4;
  s.stretch[t].direction = Eigen::Vector2d(0.6, 0.8);
  REQUIRE(clipStretch(s.cloth, s.stretch, clipOptions(0.1), s.growth));
  int grown = 0;
  for (const Mat2& G : s.growth) {
    CHECK(principalStretch(G.transpose() * G).sigma_2 >= 1.0 - 1e-12);
    grown += (G - Mat2::Identity()).norm() > 1e-12 ? 1 : 0;
  }
  CHECK(grown > 4);
  CHECK(grown < 20);
}
