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
  CHECK_FALSE(StretchClip(0.1).clip(s.cloth, s.stretch, s.growth));
  for (const Mat2& G : s.growth) CHECK(G == Mat2::Identity());
}

TEST_CASE("evenly stretched cloth grows by small steps until its stretch has reached the goal in every direction") {
  Mat3 map;
  map << 1.3, 0.2, 0.0, 0.1, 1.25, 0.0, 0.0, 0.3, 1.0;
  Stretched s(map);
  const Positions x = s.mesh.positions * map.transpose();
  StretchClip clip(0.1);
  int rounds = 0;
  while (clip.clip(s.cloth, s.stretch, s.growth)) {
    REQUIRE(++rounds < 50);
    std::vector<Mat2> edges = s.cloth.restEdges();
    for (int t = 0; t < s.cloth.triangleCount(); ++t) {
      CHECK(principalStretch(s.growth[t].transpose() * s.growth[t]).sigma_1 < 1.0201);
      edges[t] = s.growth[t] * edges[t];
    }
    s.cloth.setRest({s.cloth.restPositions(), edges});
    measureStretch(s.cloth, x, s.stretch);
  }
  CHECK(rounds > 5);
  for (const Stretch& stretch : s.stretch) {
    CHECK(stretch.sigma_1 < 1.1);
    CHECK(stretch.sigma_1 > stretchGoal(0.1, 1.0).grow_to - 1e-9);
  }
}

TEST_CASE("cloth that a load keeps stretched stops growing at the upper bound, and is counted") {
  const Mat3 map = Vec3(1.0, 1.3, 1.0).asDiagonal();
  Stretched s(map);
  StretchClip clip(0.1);
  int rounds = 0;
  while (clip.clip(s.cloth, s.stretch, s.growth)) {  // the stretch stays the same for every rest shape
    REQUIRE(++rounds < 200);
    std::vector<Mat2> edges = s.cloth.restEdges();
    for (int t = 0; t < s.cloth.triangleCount(); ++t) edges[t] = s.growth[t] * edges[t];
    s.cloth.setRest({s.cloth.restPositions(), edges});
  }
  CHECK(rounds > 20);
  CHECK(clip.fullyGrown() == s.cloth.triangleCount());
}

TEST_CASE("cloth that has grown may come nearer to the limit, but stays below it") {
  CHECK(stretchGoal(0.1, 1.0).act_above < stretchGoal(0.1, 1.3).act_above);
  CHECK(stretchGoal(0.1, 1.3).act_above < stretchGoal(0.1, 1.7).act_above);
  CHECK(stretchGoal(0.1, 5.0).act_above < 1.1);
  for (const double growth : {0.9, 1.0, 1.5, 3.0})
    CHECK(stretchGoal(0.1, growth).grow_to < stretchGoal(0.1, growth).act_above);
}

TEST_CASE("one stretched triangle shares its growth with its neighbours, and none shrinks") {
  Stretched s(Mat3::Identity());
  const int t = 60;
  s.stretch[t].sigma_1 = 1.4;
  s.stretch[t].direction = Eigen::Vector2d(0.6, 0.8);
  REQUIRE(StretchClip(0.1).clip(s.cloth, s.stretch, s.growth));
  int grown = 0;
  for (const Mat2& G : s.growth) {
    CHECK(principalStretch(G.transpose() * G).sigma_2 >= 1.0 - 1e-12);
    grown += (G - Mat2::Identity()).norm() > 1e-12 ? 1 : 0;
  }
  CHECK(grown > 4);
  CHECK(grown < 20);
}
