#include "garment/comfort.h"

#include <catch2/catch.hpp>

#include "garment/mesh_quality.h"
#include "solver/base/error.h"
#include "solver/mesh/topology.h"
#include "tests/garment/tools.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

/// Makes a tube that lies on the surface of the capsule.
LoopedMesh skin() {
  LoopedMesh tube;
  tube.mesh = moved(makeTube(40, 16, kRadius, 0.3), {0.0, -0.15, 0.0});
  for (const auto& loop : buildTopology(tube.mesh, "tube").boundary_loops)
    tube.loops.push_back({tube.mesh.positions(loop[0], 1) > 0.0 ? "top" : "bottom", loop});
  return tube;
}

}  // namespace

TEST_CASE("offsets are the garment's outside of the regions, a region's at its middle, and between at its rim") {
  Positions x(4, 3);
  x << 0, 0, 0, 0.04, 0, 0, 0.08, 0, 0, 0.2, 0, 0;
  const std::vector<double> offsets = comfortOffsets(x, 0.005, {{Vec3::Zero(), 0.1, 0.03}});
  CHECK(offsets[0] == Approx(0.03));
  CHECK(offsets[1] == Approx(0.03));
  CHECK((offsets[2] > 0.005 && offsets[2] < 0.03));
  CHECK(offsets[3] == 0.005);
}

TEST_CASE("a later region acts upon what an earlier one left") {
  Positions x(1, 3);
  x << 0, 0, 0;
  CHECK(comfortOffsets(x, 0.005, {{Vec3::Zero(), 0.1, 0.03}, {Vec3::Zero(), 0.1, 0.01}})[0] == Approx(0.01));
}

TEST_CASE("a region beside the garment is refused") {
  Positions x(1, 3);
  x << 0, 0, 0;
  const Brush near{Vec3::Zero(), 0.1, 0.03}, far{{5, 0, 0}, 0.1, 0.03};
  CHECK_THROWS_AS(comfortOffsets(x, 0.005, {near, far}), InputError);
  CHECK_THROWS_WITH(comfortOffsets(x, 0.005, {near, far}),
                    "comfort.region number 2: at = [5, 0, 0], radius = 0.1: touches no vertex");
}

TEST_CASE("a garment is moved clear of the body, by as much as each place asks for and little more") {
  const TriangleMesh body = capsuleBody();
  const TriangleTree tree(body.positions, body.triangles);
  LoopedMesh tube = skin();
  const std::vector<double> offsets =
      comfortOffsets(tube.mesh.positions, 0.005, {{Vec3(0.0, 0.0, kRadius), 0.1, 0.03}});
  CHECK(moveClear(tree, offsets, tube) == 0);
  double excess = 0.0;
  const MeshQuality quality = meshQuality(tube.mesh, tree, offsets);
  CHECK(quality.too_near == 0);
  CHECK(quality.self_intersections == 0);
  for (int v = 0; v < tube.mesh.positions.rows(); ++v) {
    const double distance = tree.signedDistance(tube.mesh.positions.row(v), 1.0);
    CHECK(distance > offsets[v] - 1e-5);
    excess += (distance - offsets[v]) / static_cast<double>(offsets.size());
    CHECK(distance < 0.032);
  }
  CHECK(excess < 0.004);
}

TEST_CASE("where two limbs leave less room than two offsets the garment keeps to the middle") {
  const TriangleMesh limb = capsuleBody();
  const double gap = 0.006;
  const TriangleMesh body = joined(limb, moved(limb, {2.0 * kRadius + gap, 0.0, 0.0}));
  const TriangleTree tree(body.positions, body.triangles);
  LoopedMesh tube = skin();
  const std::vector<double> offsets(tube.mesh.positions.rows(), 0.005);
  CHECK(moveClear(tree, offsets, tube) > 0);
  for (int v = 0; v < tube.mesh.positions.rows(); ++v)
    CHECK(tree.signedDistance(tube.mesh.positions.row(v), 1.0) > 0.3 * gap);
}
