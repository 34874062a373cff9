#include "garment/looped_mesh.h"

#include <catch2/catch.hpp>

#include "garment/remesh.h"
#include "solver/mesh/topology.h"
#include "tests/sheet.h"

using namespace ease;
using Catch::Contains;

namespace {

const TriangleMesh kTube = makeTube(24, 4, 0.1, 0.3);

LoopedMesh named(const TriangleMesh& tube) {
  LoopedMesh mesh{tube, {}};
  for (const auto& loop : buildTopology(tube, "tube").boundary_loops)
    mesh.loops.push_back({tube.positions(loop[0], 1) > 0.15 ? "top" : "bottom", loop});
  return mesh;
}

}  // namespace

TEST_CASE("loops keep their names, and one that is lost is named") {
  const LoopedMesh before = named(kTube);
  const LoopedMesh after = withLoopNames(remeshed(kTube, 0.03), before);
  REQUIRE(after.loops.size() == 2);
  for (const NamedLoop& loop : after.loops)
    for (const Vec3& x : positionsOf(loop.vertices, after.mesh.positions))
      CHECK(x.y() == Approx(loop.name == "top" ? 0.3 : 0.0).margin(1e-9));
  LoopedMesh three = before;
  three.loops.push_back({"sleeve", before.loops[0].vertices});
  CHECK_THROWS_WITH(withLoopNames(kTube, three), Contains("sleeve") || Contains("top"));
}

TEST_CASE("positions of vertices come in the order asked for") {
  const std::vector<Vec3> points = positionsOf({30, 2, 30}, kTube.positions);
  REQUIRE(points.size() == 3);
  CHECK(points[0] == Vec3(kTube.positions.row(30)));
  CHECK(points[1] == Vec3(kTube.positions.row(2)));
  CHECK(points[2] == points[0]);
}
