#include "apps/pose_files.h"

#include "solver/mesh/topology.h"
#include "tests/apps/scene_files.h"

using namespace ease;
using Catch::Contains;
using Catch::EndsWith;

TEST_CASE("a hole far from the garment is closed the same way in every pose, and told with its place and size") {
  const Files files;
  TriangleMesh open = kBox;
  open.triangles.conservativeResize(10, 3);  // without its lid
  files.write("first.obj", open);
  open.positions.col(1) *= 1.01;
  files.write("second.obj", open);
  const SceneInput input = files.read();
  CHECK(input.body_triangles.rows() == 12);
  CHECK(buildTopology({input.poses[1], input.body_triangles}, "body").boundary_loops.empty());
  REQUIRE(input.warnings.size() == 1);
  CHECK_THAT(
      input.warnings[0],
      Contains("first.obj: 1 hole was closed, as in every pose: about (0.000, 1.700, 0.000), 0.57 m wide, 4 edges"));
}

TEST_CASE("a hole within the garment's reach is refused with what to do, and closed where the scene says so") {
  const Files files;
  files.write("tube.obj", box(0.23, 1.2, 1.72, false));
  TriangleMesh open = kBox;
  open.triangles.conservativeResize(10, 3);
  files.write("first.obj", open);
  files.write("second.obj", open);
  CHECK_THAT(files.errorOf(),
             Contains("the body has a hole within 0.05 m of the garment, about (0.000, 1.700, 0.000)") &&
                 EndsWith("or let Ease close it: [body] holes = \"close\""));
  CHECK(files.read("", "holes = 'close'\n").body_triangles.rows() == 12);
}

TEST_CASE("a body's file that holds the garment, too, is refused as such") {
  const Files files;
  TriangleMesh both{Positions(16, 3), Triangles(20, 3)};
  both.positions << kBox.positions, kTube.positions;
  both.triangles << kBox.triangles, kTube.triangles.array() + 8;
  files.write("first.obj", both);
  files.write("second.obj", both);
  CHECK_THAT(files.errorOf(), Contains("first.obj: the body has an open edge that is also the garment's") &&
                                  Contains("the file seems to hold the garment"));
}

TEST_CASE("a body inside out is turned over, one that is so in a single pose is the mirror image") {
  const Files files;
  TriangleMesh turned = kBox;
  turned.triangles.col(1).swap(turned.triangles.col(2));
  files.write("first.obj", turned);
  files.write("second.obj", turned);
  const SceneInput input = files.read();
  CHECK(input.body_triangles == kBox.triangles);
  REQUIRE(input.warnings.size() == 1);
  CHECK_THAT(input.warnings[0], Contains("first.obj: inside out: its triangles face inwards and were turned over"));
  TriangleMesh mirrored = turned;
  mirrored.positions.col(0) *= -1.0;
  files.write("second.obj", mirrored);
  CHECK_THAT(files.errorOf(), Contains("second.obj: is inside out where") && Contains("mirror"));
}

TEST_CASE("a body whose vertices are doubled along seams is welded and told, weld = false keeps it apart") {
  const Files files;
  TriangleMesh seamed = kBox;  // floor and lid with vertices of their own
  seamed.positions.conservativeResize(16, 3);
  seamed.positions.bottomRows(8) = kBox.positions;
  seamed.triangles.bottomRows(4).array() += 8;
  files.write("first.obj", seamed);
  files.write("second.obj", seamed);
  const SceneInput input = files.read();
  CHECK(input.poses[1] == kBox.positions);
  CHECK(input.body_triangles == kBox.triangles);
  REQUIRE(input.warnings.size() == 1);
  CHECK_THAT(input.warnings[0], Contains("first.obj: 8 vertices lay at the place of another one along open edges"));
  CHECK(files.read("", "weld = false\n").poses[1].rows() == 16);
}

TEST_CASE("unit and axes of the files are keys, the garment has those of the body") {
  const Files files;
  const auto write = [&](const char* name, const TriangleMesh& mesh) {  // in cm, z up, facing -y
    TriangleMesh turned = mesh;
    turned.positions.col(1) = -100.0 * mesh.positions.col(2);
    turned.positions.col(2) = 100.0 * mesh.positions.col(1);
    turned.positions.col(0) *= 100.0;
    files.write(name, turned);
  };
  write("first.obj", kBox);
  write("second.obj", kBox);
  write("tube.obj", kTube);
  const SceneInput input = files.read("", "unit = 'cm'\nup = 'z'\n");
  CHECK(input.poses[1].isApprox(kBox.positions, 1e-12));
  CHECK(input.garment.positions.isApprox(kTube.positions, 1e-12));
  CHECK(input.warnings.empty());
  CHECK_THAT(files.errorOf("", "up = 'z'\nfacing = '-z'\n"), Contains("facing = '-z': expected an axis across"));
  CHECK_THAT(files.errorOf("", "unit = 'km'\n"), Contains("expected 'm', 'dm', 'cm'"));
}

TEST_CASE("poses that stand elsewhere are aligned and told, or kept where the scene says so") {
  const Files files;
  TriangleMesh away = kBox;
  away.positions.row(0).x() -= 0.01;  // no symmetry
  files.write("first.obj", away);
  const Positions here = away.positions;
  away.positions.col(0) *= -1.0;  // half a turn and three metres on
  away.positions.col(2) *= -1.0;
  away.positions.col(0).array() += 3.0;
  files.write("second.obj", away);
  const SceneInput input = files.read();
  CHECK((input.poses[1] - here).cwiseAbs().maxCoeff() < 1e-12);
  CHECK_THAT(input.warnings.at(0), Contains("'second' stood 3 m and 180 degrees from 'first'"));
  const SceneInput kept = files.read("", "align = false\nseconds_per_pose = 3\n");
  CHECK(kept.poses[1] == away.positions);
}

TEST_CASE("a body that moves faster than people do is told") {
  const Files files;
  files.write("second.obj", box(0.27, 0.0, 1.7, true));
  CHECK_THAT(files.read("", "seconds_per_pose = 0.005\n").warnings.at(0), Contains("the surface moves at 9.9 m/s"));
}

TEST_CASE("poses of other size than a person's are warned of, and one of other size than the first is refused") {
  const Files files;
  for (const char* pose : {"first.obj", "second.obj"}) files.write(pose, box(0.2, 0.0, 4.0, true));
  const SceneInput input = files.read();
  CHECK_THAT(input.warnings.at(0), Contains("first.obj: the body is 4 m tall") && Contains("check unit"));
  TriangleMesh inches = box(0.2, 0.0, 4.0, true);
  inches.positions /= 0.0254;
  files.write("second.obj", inches);
  CHECK_THAT(files.errorOf(), Contains("second.obj: 39.4 times as large as the first pose") && Contains("[body] unit"));
}

TEST_CASE("poses numbered differently are refused, or matched by their triangles") {
  const Files files;
  TriangleMesh renumbered = kBox;
  for (int v = 0; v < 8; ++v) renumbered.positions.row(7 - v) = kBox.positions.row(v);
  renumbered.triangles = 7 - kBox.triangles.array();
  files.write("second.obj", renumbered);
  CHECK_THAT(files.errorOf(), Contains("second.obj") && Contains("triangles"));
  CHECK(files.read("", "match = 'triangles'\n").poses[1] == kBox.positions);
}

TEST_CASE("a pose that returns is the same pose") {
  const Files files;
  files.write("second.obj", box(0.25, 0.0, 1.7, true));
  const std::string toml = "[body]\nposes = ['first.obj', 'second.obj', 'first.obj']\n[garment]\nmesh = 'tube.obj'\n";
  const SceneInput input = readSceneInput(readScene(files.directory.write("scene.toml", toml)));
  REQUIRE(input.poses.size() == 3);
  CHECK(input.poses[2] == input.poses[0]);
  CHECK(input.poses[1] != input.poses[0]);
}
