#include "garment/boundary_loop.h"

#include <catch2/catch.hpp>

#include "solver/base/error.h"
#include "tests/garment/tools.h"

using namespace ease;
using Catch::Contains;

namespace {

constexpr double kSmoothing = 0.01;  // m

std::vector<Vec3> loopOn(const TriangleMesh& body, const LoopRequest& request) {
  return placed(findLoops(body, buildTopology(body, "body"), {request}, kSmoothing)[0].curve, body.positions);
}

void checkRefused(const TriangleMesh& body, const LoopRequest& request, const std::string& message) {
  CHECK_THROWS_AS(findLoops(body, buildTopology(body, "body"), {request}, kSmoothing), InputError);
  CHECK_THROWS_WITH(findLoops(body, buildTopology(body, "body"), {request}, kSmoothing), Contains(message));
}

/// Computes the largest angle between consecutive segments, degrees; ignores segments shorter than a millimetre.
double sharpestTurn(const std::vector<Vec3>& loop) {
  std::vector<Vec3> directions;
  Vec3 last = loop.front();
  for (size_t i = 1; i <= loop.size(); ++i) {
    const Vec3 step = loop[i % loop.size()] - last;
    if (step.norm() < 1e-3) continue;
    directions.push_back(step.normalized());
    last = loop[i % loop.size()];
  }
  double sharpest = 0.0;
  for (size_t i = 0; i < directions.size(); ++i)
    sharpest = std::max(sharpest, std::acos(std::min(1.0, directions[i].dot(directions[(i + 1) % directions.size()]))));
  return sharpest * 180.0 / M_PI;
}

}  // namespace

TEST_CASE("a plane's loop lies in the plane and goes once around") {
  const std::vector<Vec3> loop = loopOn(capsuleBody(), planeLoop("waist", {0, 0.05, 0.12}, {0, 1, 0.2}));
  for (const Vec3& x : loop) CHECK(std::abs(Vec3(0, 1, 0.2).normalized().dot(x - Vec3(0, 0.05, 0.12))) < 5e-4);
  CHECK(polygonLength(loop, true) == Approx(2.0 * M_PI * kRadius).epsilon(0.02));
}

TEST_CASE("of the loops that a plane cuts, the nearest to the point is taken") {
  const TriangleMesh body = joined(capsuleBody(), moved(capsuleBody(), {0.5, 0, 0}));
  LoopRequest request = planeLoop("left", {0, 0, 0}, {0, 1, 0});
  request.plane->near = {0.5, 0, 0};
  for (const Vec3& x : loopOn(body, request)) CHECK(x.x() > 0.3);
}

TEST_CASE("a loop through points on a circle is that circle") {
  const std::vector<Vec3> loop = loopOn(capsuleBody(), pointLoop("waist", 0.03, 4));
  for (const Vec3& x : loop) CHECK(std::abs(x.y() - 0.03) < 4e-3);
  CHECK(polygonLength(loop, true) == Approx(2.0 * M_PI * kRadius).epsilon(0.02));
}

TEST_CASE("a loop through points comes near to them, and is smooth") {
  const LoopRequest request = pointLoop("waist", 0.0, 8, 0.05);
  const std::vector<Vec3> loop = loopOn(capsuleBody(), request);
  for (const Vec3& x : request.points) CHECK(polygonDistance(loop, true, x) < 0.012);
  CHECK(sharpestTurn(loop) < 40.0);
}

TEST_CASE("vertices of the body serve as points") {
  const TriangleMesh body = capsuleBody();
  LoopRequest request{"waist", {}, {}, {}};
  for (const Vec3& x : pointLoop("", 0.0, 5).points) {
    Eigen::Index nearest = 0;
    (body.positions.rowwise() - x.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    request.vertices.push_back(static_cast<int>(nearest));
  }
  for (const Vec3& x : loopOn(body, request)) CHECK(std::abs(x.y()) < 0.02);
}

TEST_CASE("a loop found on one pose goes along into another") {
  const TriangleMesh body = capsuleBody();
  const BoundaryLoop loop =
      findLoops(body, buildTopology(body, "body"), {pointLoop("waist", 0.02, 6, 0.03)}, kSmoothing)[0];
  const std::vector<Vec3> before = placed(loop.curve, body.positions);
  // The pose is sheared and turned by an affine map: up to round-off, the map moves every point of the loop alike.
  Eigen::Matrix3d map;
  map << 0.8, -0.3, 0.1, 0.4, 1.1, 0.0, -0.1, 0.2, 0.9;
  const Positions posed = body.positions * map.transpose();
  const std::vector<Vec3> after = placed(loop.curve, posed);
  for (size_t i = 0; i < before.size(); ++i) CHECK((after[i] - map * before[i]).norm() < 1e-12);
}

TEST_CASE("an impossible loop is refused by name") {
  const TriangleMesh body = capsuleBody();
  LoopRequest two = pointLoop("cuff", 0.0, 4);
  two.points.resize(2);
  checkRefused(body, two, "boundary 'cuff': 2 points: expected at least 3");
  LoopRequest far = pointLoop("cuff", 0.0, 4);
  far.points[2].z() -= 0.52;
  checkRefused(body, far, "boundary 'cuff': point 2 = [");
  checkRefused(body, far, "is 0.52 m from the body: expected within 0.1 m");
  checkRefused(body, {"cuff", {}, {0, 1, 999999}, {}}, "boundary 'cuff': vertex 999999: expected 0 to ");
  checkRefused(body, planeLoop("cuff", {0, 2, 0}, {0, 1, 0}), "boundary 'cuff': its plane does not cut the body");

  LoopRequest eight = pointLoop("cuff", 0.0, 4);  // its points form a figure eight
  eight.points = {{0, 0.1, 0.12}, {0.085, -0.1, 0.085}, {0.085, 0.1, 0.085}, {0, -0.1, 0.12}};
  checkRefused(body, eight, "boundary 'cuff': it crosses itself");

  LoopRequest apart = pointLoop("cuff", 0.0, 3);
  apart.points[1].x() += 0.5;
  checkRefused(joined(body, moved(body, {0.5, 0, 0})), apart, "boundary 'cuff': its points 0 and 1 lie on parts");

  LoopRequest tiny{"cuff", {{0, 0, 0.12}, {0.04, 0, 0.113}, {0.02, 0.035, 0.118}}, {}, {}};
  CHECK_THROWS_WITH(findLoops(body, buildTopology(body, "body"), {tiny}, 0.05), Contains("smoothing leaves nothing"));
}
