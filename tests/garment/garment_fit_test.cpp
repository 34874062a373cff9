#include "garment/garment_fit.h"

#include <catch2/catch.hpp>

#include "solver/base/error.h"
#include "solver/mesh/topology.h"
#include "tests/garment/tools.h"
#include "tests/sheet.h"

using namespace ease;
using Catch::Contains;

namespace {

constexpr double kHeight = 0.3;

/// Computes the distance to an infinite cylinder around the y axis.
Distance cylinder(const Vec3& x) {
  const double r = std::hypot(x.x(), x.z());
  return {r - kRadius, Vec3(x.x() / r, 0.0, x.z() / r)};
}

const std::vector<Plane> kLevel = {{{0.0, 0.0, 0.0}, -Vec3::UnitY()}, {{0.0, kHeight, 0.0}, Vec3::UnitY()}};
const std::vector<Plane> kTilted = {kLevel[0], {{0.0, kHeight, 0.0}, Vec3(0.4, 1.0, 0.1).normalized()}};

/// Makes a tube between the two cuts; its vertices lie up to a few millimetres off the cuts and off the cylinder.
TriangleMesh roughTube(int around, int along, const std::vector<Plane>& cuts) {
  TriangleMesh tube = makeTube(around, along, kRadius, kHeight);
  const Vec3 top = cuts[1].normal / cuts[1].normal.y();
  for (auto x : tube.positions.rowwise()) x.y() *= 1.0 - (top.x() * x.x() + top.z() * x.z()) / kHeight;
  tube.positions += 4e-3 * randomPositions(static_cast<int>(tube.positions.rows()), 5);
  return tube;
}

std::vector<std::vector<int>> loopsOf(const TriangleMesh& mesh) {
  return buildTopology(mesh, "mesh").boundary_loops;
}

/// Computes the ratio of the longest to the shortest edge of a loop.
double unevenness(const std::vector<int>& loop, const Positions& positions) {
  double longest = 0.0, shortest = 1.0;
  for (size_t i = 0; i < loop.size(); ++i) {
    const double length = (positions.row(loop[i]) - positions.row(loop[(i + 1) % loop.size()])).norm();
    longest = std::max(longest, length);
    shortest = std::min(shortest, length);
  }
  return longest / shortest;
}

/// Computes the smallest distance of the vertices, edge midpoints and centroids to the body, m.
double leastDistance(const DistanceField& body, const TriangleMesh& mesh) {
  double least = 1.0;
  for (const auto& t : mesh.triangles.rowwise()) {
    const Vec3 a = mesh.positions.row(t[0]), b = mesh.positions.row(t[1]), c = mesh.positions.row(t[2]);
    for (const Vec3& x :
         {a, b, c, Vec3(0.5 * (a + b)), Vec3(0.5 * (b + c)), Vec3(0.5 * (c + a)), Vec3((a + b + c) / 3.0)})
      least = std::min(least, body(x).value);
  }
  return least;
}

}  // namespace

TEST_CASE("a settled garment lies on the surface, its boundary evenly on the curves where planes cut it") {
  for (const std::vector<Plane>& cuts : {kLevel, kTilted}) {
    TriangleMesh tube = roughTube(40, 16, cuts);
    const double before = smallestAngle(tube);
    settleOnSurface(cylinder, cuts, tube);
    for (int v = 0; v < tube.positions.rows(); ++v) CHECK(std::abs(cylinder(tube.positions.row(v)).value) < 1e-6);
    CHECK(smallestAngle(tube) > before);
    for (const std::vector<int>& loop : loopsOf(tube)) {
      const Plane& cut = cuts[tube.positions(loop[0], 1) > 0.1 ? 1 : 0];
      for (const int v : loop) CHECK(std::abs(planeDistance(cut, tube.positions.row(v))) < 1e-12);
      CHECK(unevenness(loop, tube.positions) < 1.2);
    }
  }
}

TEST_CASE("of a coarse garment only the boundary settles, without gliding") {
  TriangleMesh tube = roughTube(10, 4, kTilted);
  const TriangleMesh before = tube;
  settleOnSurface(cylinder, kTilted, tube);
  CHECK(tube.positions.middleRows(10, 30) == before.positions.middleRows(10, 30));
  for (const std::vector<int>& loop : loopsOf(tube))
    for (const int v : loop) {
      CHECK(std::abs(cylinder(tube.positions.row(v)).value) < 1e-6);
      CHECK(std::abs(planeDistance(kTilted[v < 10 ? 0 : 1], tube.positions.row(v))) < 1e-12);
      CHECK((tube.positions.row(v) - before.positions.row(v)).norm() < 0.012);
    }
}

TEST_CASE("vertices are moved out until edges and triangles are clear too, and little further") {
  constexpr double kClearance = 0.005, kMargin = 0.001;
  TriangleMesh tube = makeTube(12, 4, kRadius + 0.003, kHeight);  // its edges cut through the cylinder
  REQUIRE(leastDistance(cylinder, tube) < 0.0);
  keepClear(cylinder, kLevel, kClearance, tube);
  CHECK(leastDistance(cylinder, tube) >= kClearance + kMargin);
  // Distance of the corners if the tube's cross-section were a regular polygon.
  const double corners = (kRadius + kClearance + kMargin) / std::cos(M_PI / 12.0) - kRadius;
  for (int v = 0; v < tube.positions.rows(); ++v) CHECK(cylinder(tube.positions.row(v)).value < corners + 8e-4);
  for (const std::vector<int>& loop : loopsOf(tube))
    for (const int v : loop) CHECK(tube.positions(v, 1) == (v < 12 ? 0.0 : kHeight));
}

TEST_CASE("what is clear of the body already stays as it is") {
  TriangleMesh tube = makeTube(40, 16, kRadius + 0.01, kHeight);
  const Positions before = tube.positions;
  keepClear(cylinder, kLevel, 0.005, tube);
  CHECK(tube.positions == before);
}

TEST_CASE("a garment whose boundary cannot leave the body within its plane is an error") {
  const auto floor = [](const Vec3& x) { return Distance{x.y() - 0.1, Vec3::UnitY()}; };
  TriangleMesh tube = makeTube(12, 4, kRadius, kHeight);  // its lower end lies inside the floor
  CHECK_THROWS_AS(keepClear(floor, kLevel, 0.005, tube), ComputationError);
  CHECK_THROWS_WITH(keepClear(floor, kLevel, 0.005, tube), Contains("too large to stay clear of the body"));
}
