#include "garment/region.h"

#include <catch2/catch.hpp>

#include "garment/remesh.h"
#include "solver/base/error.h"
#include "tests/garment/tools.h"

using namespace ease;
using Catch::Contains;

namespace {

LoopedMesh regionOf(const TriangleMesh& body, const std::vector<LoopRequest>& requests, const Vec3& seed) {
  const Topology topology = buildTopology(body, "body");
  return enclosedRegion(body, topology, findLoops(body, topology, requests, 0.01), seed);
}

const LoopRequest kTop = planeLoop("top", {0, 0.2, 0}, {0, 1, 0}),
                  kBottom = planeLoop("bottom", {0, -0.2, 0}, {0, 1, 0});
const Vec3 kFront(0, 0, kRadius);

}  // namespace

TEST_CASE("the parts that loops divide a body into have together its area") {
  const TriangleMesh body = capsuleBody();
  const LoopRequest waist = pointLoop("waist", 0.0, 8, 0.05);
  const double upper = areaOf(regionOf(body, {waist}, {0, 0.3, 0}).mesh);
  const double lower = areaOf(regionOf(body, {waist}, {0, -0.3, 0}).mesh);
  CHECK(upper + lower == Approx(areaOf(body)).epsilon(1e-12));
  CHECK(upper > 0.2 * areaOf(body));
  CHECK(lower > 0.2 * areaOf(body));
}

TEST_CASE("a region ends exactly on its loops, each its own") {
  const TriangleMesh body = capsuleBody();
  const Topology topology = buildTopology(body, "body");
  const std::vector<BoundaryLoop> loops = findLoops(body, topology, {kTop, pointLoop("bottom", -0.1, 6, 0.02)}, 0.01);
  const LoopedMesh region = enclosedRegion(body, topology, loops, kFront);
  CHECK(eulerCharacteristic(region.mesh) == 0);  // the region is a tube
  REQUIRE(buildTopology(region.mesh, "region").boundary_loops.size() == 2);
  for (size_t l = 0; l < loops.size(); ++l) {
    CHECK(region.loops[l].name == loops[l].name);
    const std::vector<Vec3> on_body = placed(loops[l].curve, body.positions);
    const std::vector<Vec3> border = positionsOf(region.loops[l].vertices, region.mesh.positions);
    REQUIRE(border.size() == on_body.size());
    for (size_t i = 0; i < border.size(); ++i) CHECK((border[i] - on_body[i]).norm() == 0.0);
  }
}

TEST_CASE("the part of a tube between two planes has the tube's area") {
  const LoopedMesh region = regionOf(capsuleBody(), {kTop, kBottom}, kFront);
  CHECK(areaOf(region.mesh) == Approx(2.0 * M_PI * kRadius * 0.4).epsilon(0.01));
}

TEST_CASE("one loop makes a cap, three make trousers") {
  CHECK(eulerCharacteristic(regionOf(capsuleBody(), {kTop}, {0, 0.4, 0}).mesh) == 1);
  LoopRequest patch{"patch", {{0.12, 0.08, 0}, {0.106, 0, 0.056}, {0.12, -0.08, 0}, {0.106, 0, -0.056}}, {}, {}};
  const LoopedMesh three = regionOf(capsuleBody(), {kTop, kBottom, patch}, {-kRadius, 0, 0});
  CHECK(eulerCharacteristic(three.mesh) == -1);
}

TEST_CASE("loops that pass through the same triangles divide them") {
  const LoopedMesh strip =
      regionOf(capsuleBody(), {kTop, planeLoop("below", {0, 0.199, 0}, {0, 1, 0})}, {0, 0.1995, kRadius});
  CHECK(areaOf(strip.mesh) == Approx(2.0 * M_PI * kRadius * 0.001).epsilon(0.3));
  CHECK(eulerCharacteristic(strip.mesh) == 0);
}

TEST_CASE("a seed or loops that enclose nothing are refused") {
  const TriangleMesh body = capsuleBody();
  const auto messageOf = [&](const std::vector<LoopRequest>& loops, const Vec3& seed) {
    try {
      regionOf(body, loops, seed);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(messageOf({kTop, kBottom}, {0, 0.42, 0}) ==
        "seed = [0, 0.42, 0] lies outside the boundaries: the part of the body around it ends at 'top', not at "
        "'bottom'");
  CHECK(messageOf({kTop, kBottom}, {0, 0, 0.62}) ==
        "region: seed = [0, 0, 0.62] is 0.5 m from the body: expected within 0.2 m");
  LoopRequest tilted = kTop;
  tilted.name = "tilted";
  tilted.plane->normal = {0, 1, 0.3};
  CHECK(messageOf({kTop, tilted}, kFront) ==
        "boundaries 'top' and 'tilted' cross or touch: expected loops that share no point");
}

TEST_CASE("a remeshed region keeps its loops, its names and the number of vertices asked for") {
  const LoopedMesh region = regionOf(capsuleBody(), {kTop, pointLoop("bottom", -0.1, 6, 0.02)}, kFront);
  const LoopedMesh even = withLoopNames(remeshedTo(region.mesh, 500, "tube"), region);
  CHECK(std::abs(even.mesh.positions.rows() - 500) <= 15);
  for (size_t l = 0; l < region.loops.size(); ++l) {
    CHECK(even.loops[l].name == region.loops[l].name);
    const std::vector<Vec3> before = positionsOf(region.loops[l].vertices, region.mesh.positions);
    const std::vector<Vec3> after = positionsOf(even.loops[l].vertices, even.mesh.positions);
    for (const Vec3& x : after) CHECK(polygonDistance(before, true, x) < 1e-9);
    for (const Vec3& x : before)
      CHECK(polygonDistance(after, true, x) < 2.5e-3);  // the region cuts off no corner of the loop
  }
}
