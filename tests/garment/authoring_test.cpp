#include "garment/authoring.h"

#include <catch2/catch.hpp>

#include "garment/mesh_quality.h"
#include "tests/garment/tools.h"

using namespace ease;

namespace {

GarmentTools tubeTools() {
  GarmentTools tools;
  tools.boundaries = {planeLoop("top", {0, 0.2, 0}, {0, 1, 0}), pointLoop("hem", -0.1, 8, 0.03)};
  tools.seed = {0, 0, kRadius};
  tools.resolution = 800;
  return tools;
}

void checkQuality(const MeshQuality& quality, int vertices) {
  CHECK(std::abs(quality.vertices - vertices) <= 0.03 * vertices);
  CHECK(quality.smallest_angle_deg > 5.0);
  CHECK(quality.share_from_20_deg >= 0.999);
  CHECK(quality.self_intersections == 0);
  CHECK(quality.vertex_distance_m >= 0.00499);
  CHECK(quality.midpoint_distance_m >= 0.00499);
  CHECK(quality.centroid_distance_m >= 0.00499);
  CHECK(quality.too_near == 0);
}

}  // namespace

TEST_CASE("an authored garment has the vertices asked for, good triangles, and keeps its distance everywhere") {
  const TriangleMesh body = capsuleBody();
  const TriangleTree tree(body.positions, body.triangles);
  const AuthoredGarment made = authorGarment(body, tubeTools(), {0.005, {}});
  const MeshQuality quality = meshQuality(made.garment.mesh, tree, made.offsets);
  checkQuality(quality, 800);
  CHECK(quality.vertex_distance_m < 0.006);  // only slightly more than the offset
  for (const int t : made.body_triangle) CHECK(t >= 0);
  REQUIRE(made.garment.loops.size() == 2);
  for (const Vec3& x : positionsOf(made.garment.loops[0].vertices, made.garment.mesh.positions))
    CHECK(x.y() == Approx(0.2).margin(2e-3));
}

TEST_CASE("an edge length can be asked for instead") {
  const TriangleMesh body = capsuleBody();
  GarmentTools tools = tubeTools();
  tools.edge_length = 0.02;
  const AuthoredGarment made = authorGarment(body, tools, {0.005, {}});
  const TriangleTree tree(body.positions, body.triangles);
  CHECK(meshQuality(made.garment.mesh, tree, made.offsets).mean_edge_m == Approx(0.02).epsilon(0.1));
}

TEST_CASE("a comfort region of three centimetres clears the body by that, and leaves the rest") {
  const TriangleMesh body = capsuleBody();
  const TriangleTree tree(body.positions, body.triangles);
  const Brush belly{{0, 0.05, kRadius}, 0.2, 0.03};
  const AuthoredGarment made = authorGarment(body, tubeTools(), {0.005, {belly}});
  checkQuality(meshQuality(made.garment.mesh, tree, made.offsets), 800);
  int within = 0, behind = 0;
  for (Eigen::Index v = 0; v < made.garment.mesh.positions.rows(); ++v) {
    const Vec3 x = made.garment.mesh.positions.row(v);
    const double distance = tree.signedDistance(x, 0.1);
    if ((x - belly.at).norm() < 0.08) {
      CHECK(distance > 0.0299);
      CHECK(distance < 0.034);
      ++within;
    } else if (x.z() < -0.05) {
      CHECK(distance < 0.008);
      ++behind;
    }
  }
  CHECK(within > 10);
  CHECK(behind > 10);
}

TEST_CASE("a garment with an extension and seams is authored in one go, the same every time") {
  const TriangleMesh body = capsuleBody();
  GarmentTools tools = tubeTools();
  tools.extensions = {{"hem", {}, 0.25, 1.8}};
  tools.seams = {{"side", "hem", "top", {{kRadius, 0.0, 0.0}}, {}}};
  const AuthoredGarment made = authorGarment(body, tools, {0.005, {}});
  const TriangleTree tree(body.positions, body.triangles);
  checkQuality(meshQuality(made.garment.mesh, tree, made.offsets), 800);
  CHECK(eulerCharacteristic(made.garment.mesh) == 0);
  CHECK(std::count(made.body_triangle.begin(), made.body_triangle.end(), -1) > 100);
  CHECK(made.seams[0].vertices.size() > 8);
  const AuthoredGarment again = authorGarment(body, tools, {0.005, {}});
  CHECK(again.garment.mesh.positions == made.garment.mesh.positions);
  CHECK(again.garment.mesh.triangles == made.garment.mesh.triangles);
  CHECK(again.seams[0].vertices == made.seams[0].vertices);
}

TEST_CASE("between parts that leave less room than two offsets the garment keeps to the middle") {
  // The body is two upright capsules 6 mm apart; the garment is a sleeve around one of them.
  const TriangleMesh leg = capsule(0.25, 0.08, 12);
  const TriangleMesh body = joined(moved(leg, {-0.083, 0, 0}), moved(leg, {0.083, 0, 0}));
  const TriangleTree tree(body.positions, body.triangles);
  GarmentTools tools;
  tools.boundaries = {planeLoop("top", {0.083, 0.2, 0}, {0, 1, 0}), planeLoop("hem", {0.083, -0.2, 0}, {0, 1, 0})};
  for (LoopRequest& loop : tools.boundaries) loop.plane->near.x() = 0.163;
  tools.seed = {0.163, 0, 0};
  tools.resolution = 800;
  const AuthoredGarment made = authorGarment(body, tools, {0.01, {}});
  CHECK(made.held_vertices > 10);
  const MeshQuality quality = meshQuality(made.garment.mesh, tree, made.offsets);
  CHECK(quality.vertex_distance_m > 0.001);
  CHECK(quality.midpoint_distance_m > 0.0);
  CHECK(quality.centroid_distance_m > 0.0);
  CHECK(quality.smallest_angle_deg > 15.0);
  for (Eigen::Index v = 0; v < made.garment.mesh.positions.rows(); ++v)
    CHECK(made.garment.mesh.positions(v, 0) > -1e-3);
}

TEST_CASE("making a garment ends at whichever pause is not returned from") {
  const TriangleMesh body = capsuleBody();
  int pauses = 0;
  authorGarment(body, tubeTools(), {0.005, {}}, [&] { ++pauses; });
  CHECK(pauses >= 7);  // one after each of six parts, and at least one before a trial of remeshing
  for (int last = 1; last <= pauses; ++last) {
    int now = 0;
    const auto stop = [&] {
      if (++now == last) throw Interrupted();
    };
    CHECK_THROWS_AS(authorGarment(body, tubeTools(), {0.005, {}}, stop), Interrupted);
    CHECK(now == last);
  }
}
