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
