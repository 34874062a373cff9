#include "apps/start_check.h"

#include "tests/apps/scene_files.h"
#include "tests/tube.h"

using namespace ease;
using Catch::Contains;

TEST_CASE("a part of the garment that is the body is refused, whether it has the body's vertices or only its surface") {
  const Files files;
  TriangleMesh both{Positions(16, 3), Triangles(20, 3)};
  both.positions << kTube.positions, kBox.positions;
  both.triangles << kTube.triangles, kBox.triangles.array() + 8;
  files.write("tube.obj", both);
  CHECK_THAT(files.errorOf(), Contains("tube.obj: 8 of its 16 vertices are the body's: is the avatar in this file?"));
  both.positions.bottomRows(8) = box(0.1995, 0.0005, 1.6995, true).positions;
  files.write("tube.obj", both);
  CHECK_THAT(files.errorOf(), Contains("is the avatar in this file?"));
}

TEST_CASE("a garment inside the body is refused with how far") {
  const Files files;
  files.write("tube.obj", box(0.15, 0.8, 1.4, false));
  CHECK_THAT(files.errorOf(),
             Contains("tube.obj: 8 of 8 vertices lie inside the first pose, 'first'") && Contains("50.0 mm"));
}

TEST_CASE("a garment a few millimetres inside the body is moved out and told, its rest shape stays") {
  const Files files;
  const TriangleMesh tube = box(0.197, 0.8, 1.4, false);
  files.write("tube.obj", tube);
  const SceneInput input = files.read();
  CHECK(input.garment.positions == tube.positions);
  CHECK(startOf(input).col(0).cwiseAbs().minCoeff() > 0.1969);
  CHECK(startOf(input).leftCols(1).cwiseAbs().maxCoeff() > 0.2);
  CHECK_THAT(input.warnings.at(0), Contains("8 vertices inside the first pose") && Contains("3.0 mm"));
}

TEST_CASE(
    "triangles much larger than the part of the body that they lie on are refused with the length that would do") {
  const Files files;
  files.write("first.obj", box(0.02, 0.0, 1.7, true));
  files.write("second.obj", box(0.02, 0.0, 1.7, true));
  files.write("tube.obj", box(0.03, 0.8, 1.4, false));
  CHECK_THAT(files.errorOf(), Contains("8 triangles are too large for the part of the body") &&
                                  Contains("remesh the garment to edges of at most 0.04 m"));
}

TEST_CASE("a garment less than a millimetre inside the body may start") {
  const Files files;
  files.write("tube.obj", box(0.1995, 0.8, 1.4, false));
  CHECK(files.read().warnings.empty());
}

TEST_CASE("a garment far from the body is refused with the distance") {
  const Files files;
  files.write("tube.obj", box(0.3, 3.7, 4.0, false));
  CHECK_THAT(files.errorOf(), Contains("tube.obj: at least 2 m away from the first pose, 'first'"));
}

TEST_CASE("a triangle that is missing is warned of with its place") {
  const Files files;
  TriangleMesh ring = tube(16, 8, 2.0);
  ring.positions *= 0.29;
  ring.positions.col(1).array() += 0.8;
  files.write("tube.obj", ring);
  const size_t whole = files.read().warnings.size();
  Triangles others(ring.triangles.rows() - 1, 3);
  others << ring.triangles.topRows(100), ring.triangles.bottomRows(ring.triangles.rows() - 101);
  ring.triangles = others;
  files.write("tube.obj", ring);
  const SceneInput input = files.read();
  REQUIRE(input.warnings.size() == whole + 1);
  CHECK_THAT(input.warnings.back(),
             Contains("tube.obj: 1 hole of three edges, it lies at vertex ") && Contains("is a triangle missing?"));
}
