#include "garment/remesh.h"

#include <catch2/catch.hpp>

#include "garment/mesh_quality.h"
#include "tests/garment/tools.h"
#include "tests/sheet.h"

using namespace ease;
using Catch::Contains;

namespace {

const TriangleMesh kTube = makeTube(24, 4, 0.1, 0.3);  // its triangles are long and narrow

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
