#include "collision/moving_body.h"

#include <catch2/catch.hpp>

#include "collision/body/mannequin.h"

using namespace ease;

namespace {

struct Poses {
  TriangleMesh t = mannequin("t"), a = mannequin("a");
};

}  // namespace

TEST_CASE("the body passes through its poses, and back again") {
  const Poses poses;
  MovingBody body(poses.t.triangles, {poses.t.positions, poses.a.positions}, 4, LevelSetOptions{});
  REQUIRE(body.motionSteps() == 4);
  const std::vector<Vec3> points{{0.3, 1.4, 0.05}};
  Positions x;
  for (int k = 0; k <= 8; ++k) {
    body.prepare(k, points);
    body.positions(k, x);
    if (k % 8 == 0) CHECK((x - poses.t.positions).cwiseAbs().maxCoeff() < 1e-9);
    if (k == 4) CHECK((x - poses.a.positions).cwiseAbs().maxCoeff() < 1e-9);
    if (k == 2) CHECK((x - poses.a.positions).cwiseAbs().maxCoeff() > 0.05);
  }
}

TEST_CASE("just before and just after a level set is exchanged, distances agree") {
  const Poses poses;
  MovingBody body(poses.t.triangles, {poses.t.positions, poses.a.positions}, 12, LevelSetOptions{});
  const std::vector<Vec3> points{{0.25, 1.38, 0.06}, {0.0, 1.2, 0.14}, {0.1, 1.0, 0.12}};
  for (int k = 0; k <= 4; ++k) body.prepare(k, points);
  ContactFinder finder;
  std::vector<double> before, after;
  finder.distances(body.at(3.4999), points, before);
  finder.distances(body.at(3.5001), points, after);
  for (size_t i = 0; i < points.size(); ++i) CHECK(before[i] == Approx(after[i]).margin(5e-4));
}

TEST_CASE("a pose that returns has the distances of its first time, and those of a body that never was there") {
  const Poses poses;
  const std::vector<Positions> both = {poses.t.positions, poses.a.positions};
  MovingBody body(poses.t.triangles, both, 4, LevelSetOptions{}), fresh(poses.t.triangles, both, 4, LevelSetOptions{});
  const std::vector<Vec3> points{{0.25, 1.38, 0.06}, {0.0, 1.2, 0.14}}, others{{0.1, 1.0, 0.12}, {0.25, 1.38, 0.06}};
  const auto distances = [](MovingBody& at, int k, const std::vector<Vec3>& x) {
    at.prepare(k, x);
    std::vector<double> found;
    ContactFinder().distances(at.at(k), x, found);
    return found;
  };
  std::vector<std::vector<double>> first;
  for (int k = 0; k <= 4; ++k) first.push_back(distances(body, k, points));
  for (int k = 5; k <= 8; ++k) CHECK(distances(body, k, points) == first[8 - k]);  // the way back
  for (int k = 0; k <= 4; ++k) {                                                   // another pass, with other cloth
    CHECK(distances(body, k, others) == distances(fresh, k, others));
  }
}
