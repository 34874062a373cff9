#include "garment/extension.h"

#include <catch2/catch.hpp>

#include "garment/region.h"
#include "solver/base/error.h"
#include "tests/garment/tools.h"

using namespace ease;

namespace {

LoopedMesh tube(double wave = 0.0) {
  const TriangleMesh body = capsuleBody();
  const Topology topology = buildTopology(body, "body");
  const std::vector<LoopRequest> loops = {planeLoop("top", {0, 0.2, 0}, {0, 1, 0}), pointLoop("hem", 0.0, 8, wave)};
  return enclosedRegion(body, topology, findLoops(body, topology, loops, 0.01), {0, 0.1, kRadius});
}

std::vector<Vec3> loopOf(const LoopedMesh& garment, size_t l) {
  return positionsOf(garment.loops[l].vertices, garment.mesh.positions);
}

}  // namespace

TEST_CASE("centre of mass and vector area of a square, wherever it is and however finely divided") {
  const std::vector<Vec3> square = {{1, 5, 1}, {1, 5, 3}, {3, 5, 3}, {3, 5, 2}, {3, 5, 1.5}, {3, 5, 1}};
  CHECK((centreOfMass(square) - Vec3(2, 5, 2)).norm() < 1e-12);
  CHECK((vectorArea(square) - Vec3(0, 4, 0)).norm() < 1e-12);
}

TEST_CASE("an extension goes along the loop's axis, away from the garment, and keeps the loop's shape, scaled") {
  for (const double wave : {0.0, 0.04}) {  // a plane loop, and one that is not plane
    LoopedMesh garment = tube(wave);
    const std::vector<Vec3> before = loopOf(garment, 1);
    const double area = areaOf(garment.mesh);
    extend({"hem", {}, 0.3, 1.5}, 0.02, garment);
    const std::vector<Vec3> after = loopOf(garment, 1);
    REQUIRE(after.size() == before.size());
    const Vec3 moved = centreOfMass(after) - centreOfMass(before);
    CHECK(moved.norm() == Approx(0.3).epsilon(1e-9));
    CHECK(moved.y() < -0.299);
    CHECK(polygonLength(after, true) == Approx(1.5 * polygonLength(before, true)).epsilon(1e-9));
    CHECK(eulerCharacteristic(garment.mesh) == 0);
    const Topology topology = buildTopology(garment.mesh, "garment");  // throws if the parts are joined wrongly
    CHECK(topology.boundary_loops.size() == 2);
    if (wave == 0.0) {  // the extension is the frustum of a cone
      const double slant = std::hypot(0.3, 0.5 * kRadius);
      CHECK(areaOf(garment.mesh) - area == Approx(M_PI * 2.5 * kRadius * slant).epsilon(0.01));
    }
  }
}

TEST_CASE("an extension can be told where to go") {
  LoopedMesh garment = tube();
  extend({"hem", Vec3(0.1, -0.4, 0.0), 0.0, 1.0}, 0.02, garment);
  CHECK((centreOfMass(loopOf(garment, 1)) - Vec3(0.1, -0.4, 0.0)).norm() < 1e-9);
  CHECK((centreOfMass(loopOf(garment, 0)) - Vec3(0.0, 0.2, 0.0)).norm() < 2e-3);
}

TEST_CASE("an extension of an unknown loop is refused") {
  LoopedMesh garment = tube();
  CHECK_THROWS_AS(extend({"cuff", {}, 0.3, 1.0}, 0.02, garment), InputError);
  CHECK_THROWS_WITH(extend({"cuff", {}, 0.3, 1.0}, 0.02, garment),
                    "extension: loop = 'cuff': expected one of 'top', 'hem'");
}
