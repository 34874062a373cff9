#include "apps/garment_file.h"

#include "tests/apps/scene_files.h"

using namespace ease;
using Catch::Contains;

TEST_CASE("a garment's panels are sewn where they meet, its pins and files keep the numbers of its file") {
  const Files files;
  TriangleMesh panels = kTube;  // each wall with vertices of its own
  panels.positions.resize(24, 3);
  for (int t = 0; t < 8; ++t)
    for (int k = 0; k < 3; ++k) {
      panels.positions.row(3 * t + k) = kTube.positions.row(kTube.triangles(t, k));
      panels.triangles(t, k) = 3 * t + k;
    }
  files.write("tube.obj", panels);
  const SceneInput input = files.read("[[garment.pin]]\nvertices = [0, 18, 23]\n");
  CHECK(input.garment.positions.rows() == 8);
  REQUIRE(input.as_read);
  CHECK(input.as_read->mesh.positions == panels.positions);
  for (int v = 0; v < 24; ++v) CHECK(input.garment.positions.row(input.as_read->vertex[v]) == panels.positions.row(v));
  for (const int v : input.pins[0]) CHECK(v < 8);
  CHECK_THAT(input.warnings.at(0), Contains("tube.obj: 16 vertices lay at the place of another one"));
  CHECK_THAT(files.read("weld = false\n").warnings.at(0), Contains("8 parts that nothing joins"));
}
