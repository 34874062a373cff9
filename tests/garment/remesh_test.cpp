#include "garment/remesh.h"

#include <catch2/catch.hpp>

#include "garment/looped_mesh.h"
#include "garment/mesh_quality.h"
#include "solver/mesh/topology.h"
#include "tests/garment/tools.h"
#include "tests/sheet.h"

using namespace ease;
using Catch::Contains;

namespace {

const TriangleMesh kTube = makeTube(24, 4, 0.1, 0.3);  // long triangles

LoopedMesh named(const TriangleMesh& tube) {
  LoopedMesh mesh{tube, {}};
  for (const auto& loop : buildTopology(tube, "tube").boundary_loops)
    mesh.loops.push_back({tube.positions(loop[0], 1) > 0.15 ? "top" : "bottom", loop});
  return mesh;
}

}  // namespace

TEST_CASE("remeshing gives even triangles of the length asked for, on the same surface") {
  const TriangleMesh even = remeshed(kTube, 0.02);
  const TriangleMesh box = bodies::box({-1, -1, -1}, {1, 1, -0.9});
  const TriangleTree body(box.positions, box.triangles);
  const MeshQuality quality = meshQuality(even, body, std::vector<double>(even.positions.rows(), 0.0));
  CHECK(quality.mean_edge_m == Approx(0.02).epsilon(0.15));
  CHECK(quality.smallest_angle_deg > 15.0);
  CHECK(quality.share_from_20_deg > 0.99);
  CHECK(areaOf(even) == Approx(areaOf(kTube)).epsilon(0.01));
  CHECK(eulerCharacteristic(even) == 0);
}

TEST_CASE("remeshing to a number of vertices comes within 2.5 percent of it") {
  const int count = GENERATE(150, 400, 1000, 3000);
  CHECK(remeshedTo(kTube, count, "tube").positions.rows() == Approx(count).epsilon(0.025));
}

TEST_CASE("a number of vertices too small for the loops is refused by name") {
  CHECK_THROWS_WITH(remeshedTo(kTube, 5, "sleeve"), Contains("sleeve"));
}

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
