#include "collision/body_pins.h"

#include <catch2/catch.hpp>

#include "collision/body/mannequin.h"
#include "collision/moving_body.h"
#include "solver/mesh/triangle_gradient.h"
#include "tests/collision/bodies.h"

using namespace ease;

namespace {

/// Positions of the pins when the body has moved by the share tau in a straight line from `at` to `towards`.
std::vector<Vec3> placesOf(const std::vector<BodyTie>& pins, const Triangles& triangles, const Positions& at,
                           const Positions& towards, double tau) {
  std::vector<Vec3> places;
  for (const BodyTie& pin : pins) places.push_back(placeOf(pin, {nullptr, nullptr, &triangles, &at, &towards, tau}));
  return places;
}

}  // namespace

TEST_CASE("pins stay where they are on the body") {
  const TriangleMesh t = mannequin("t"), a = mannequin("a");
  MovingBody body(t.triangles, {t.positions, a.positions}, 4, LevelSetOptions{});
  Positions cloth(2, 3);
  cloth << 0.45, 1.42, 0.06, 0.0, 1.0, 0.15;
  const std::vector<BodyTie> pins = tieToBody({0, 1}, cloth, t.positions, t.triangles);
  for (int k = 0; k <= 4; ++k) body.prepare(k, {});
  std::vector<Vec3> places;
  for (const BodyTie& pin : pins) places.push_back(placeOf(pin, body.at(4.0)));
  REQUIRE(places.size() == 2);
  const TriangleTree t_tree(t.positions, t.triangles), a_tree(a.positions, a.triangles);
  for (int i = 0; i < 2; ++i)
    CHECK(a_tree.signedDistance(places[i], 1.0) ==
          Approx(t_tree.signedDistance(cloth.row(i).transpose(), 1.0)).margin(2e-3));
  CHECK((places[0] - cloth.row(0).transpose()).norm() > 0.1);   // the arm went down
  CHECK((places[1] - cloth.row(1).transpose()).norm() < 0.02);  // the belly did not
}

TEST_CASE("pins go along with every rotation of the body, to rounding") {
  const TriangleMesh body = bodies::box({-0.2, -0.3, -0.1}, {0.2, 0.1, 0.4});
  Positions cloth(3, 3);
  cloth << 0.25, 0.0, 0.1, -0.1, -0.2, 0.05, 0.3, 0.2, 0.5;  // beside a face, inside, off a corner
  const std::vector<BodyTie> pins = tieToBody({2, 0, 1}, cloth, body.positions, body.triangles);
  const Mat3 turn = Eigen::AngleAxisd(2.1, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  const Positions turned = body.positions * turn.transpose();
  const std::vector<Vec3> start = placesOf(pins, body.triangles, body.positions, turned, 0.0);
  const std::vector<Vec3> end = placesOf(pins, body.triangles, body.positions, turned, 1.0);
  REQUIRE(end.size() == 3);
  for (const int i : {0, 1, 2}) {
    const Vec3 x = cloth.row((i + 2) % 3);  // in the order of the vertices that were given
    CHECK((start[i] - x).norm() < 1e-14);
    CHECK((end[i] - turn * x).norm() < 1e-14);
  }
}

TEST_CASE("where the body grows along its surface, pins keep their distance from it") {
  const TriangleMesh body = bodies::box(Vec3::Zero(), Vec3::Ones());
  Positions cloth(1, 3);
  cloth << 0.3, 0.6, 1.02;
  const std::vector<BodyTie> pins = tieToBody({0}, cloth, body.positions, body.triangles);
  Positions wider = body.positions;
  wider.col(0) *= 3.0;
  const std::vector<Vec3> halfway = placesOf(pins, body.triangles, body.positions, wider, 0.5);
  CHECK((halfway[0] - Vec3(0.6, 0.6, 1.02)).norm() < 1e-14);
}

TEST_CASE("a pin on a vertex of the body is there, and without pins there is none") {
  const TriangleMesh body = bodies::box(Vec3::Zero(), Vec3::Ones());
  CHECK(tieToBody({}, Positions(0, 3), body.positions, body.triangles).empty());
  const auto pins = tieToBody({3}, body.positions, body.positions, body.triangles);
  const std::vector<Vec3> places = placesOf(pins, body.triangles, body.positions, body.positions, 0.0);
  REQUIRE(places.size() == 1);
  CHECK((places[0] - Vec3(body.positions.row(3))).norm() < 1e-14);
}
