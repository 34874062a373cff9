#include <catch2/catch.hpp>

#include "tests/apps/scene_files.h"
#include "tests/places.h"

using namespace ease;
using Catch::Contains;
using Catch::EndsWith;

TEST_CASE("a body and a garment around it are read from beside the scene") {
  const SceneInput input = Files().read("[[garment.pin]]\nloop = 'neck'\n[[garment.pin]]\nvertices = [1, 0]\n");
  CHECK(input.garment.positions == kTube.positions);
  CHECK(input.garment.triangles == kTube.triangles);
  CHECK(input.body_triangles == kBox.triangles);
  REQUIRE(input.poses.size() == 2);
  CHECK(input.poses[1] == kBox.positions);
  CHECK(input.pose_names == std::vector<std::string>{"first", "second"});
  REQUIRE(input.pins.size() == 2);
  CHECK(std::set<int>(input.pins[0].begin(), input.pins[0].end()) == std::set<int>{4, 5, 6, 7});
  CHECK(input.pins[1] == std::vector<int>{1, 0});
  CHECK(input.warnings.empty());
}

TEST_CASE("a garment alone needs no body") {
  const SceneInput input = Files().readWithoutBody("[[garment.pin]]\nloop = 'hem'\n");
  CHECK(input.poses.empty());
  CHECK(input.body_triangles.rows() == 0);
  CHECK(std::set<int>(input.pins[0].begin(), input.pins[0].end()) == std::set<int>{0, 1, 2, 3});
}

TEST_CASE("a file that a scene names and that is missing is named") {
  const Files files;
  std::filesystem::remove(files.directory.path / "second.obj");
  CHECK_THAT(files.errorOf(), Contains("second.obj"));
  std::filesystem::remove(files.directory.path / "tube.obj");
  CHECK_THAT(files.errorOf(), Contains("tube.obj"));
}

TEST_CASE("a warning is told before what follows fails") {
  const Files files;
  files.write("first.obj", box(200.0, 0.0, 1700.0, true));
  files.write("second.obj", box(200.0, 0.0, 1700.0, true));
  const std::string toml = "[body]\nposes = ['first.obj', 'second.obj']\n[garment]\nmesh = 'tube.obj'\n";
  std::vector<std::string> told;
  const auto tell = [&](const std::string& warning) { told.push_back(warning); };
  CHECK_THROWS_AS(readSceneInput(readScene(files.directory.write("scene.toml", toml)), tell), InputError);
  REQUIRE(told.size() == 1);
  CHECK_THAT(told[0],
             Contains("first.obj: the body is 1700 m tall") && Contains("[body] unit = \"mm\" would make it 1.7 m"));
}

TEST_CASE("a limit that was meant as a factor is warned of") {
  const Files files;
  CHECK(files.read("[adaption]\nlimit = 0.5\n").warnings.empty());
  const SceneInput input = files.read("[adaption]\nlimit = 1.08\n");
  REQUIRE(input.warnings.size() == 1);
  CHECK_THAT(input.warnings[0], Contains("scene.toml: [adaption] limit = 1.08: cloth stretched up to 2.08 times"));
}

TEST_CASE("a vertex without a triangle is left out and told") {
  const Files files;
  TriangleMesh loose = kTube;
  loose.positions.conservativeResize(9, 3);
  loose.positions.row(8) << 0.3, 1.0, 0.3;
  files.write("tube.obj", loose);
  const SceneInput input = files.read();
  CHECK(input.garment.positions == kTube.positions);
  CHECK_THAT(input.warnings.at(0), Contains("tube.obj: left out 1 vertex that no triangle uses"));
}

TEST_CASE("a grain square to all of a garment is refused with one that would do") {
  const Files files;
  files.write("tube.obj", {kTube.positions, kTube.triangles.topRows(2)});  // the front
  CHECK_THAT(
      files.errorOf("grain = [0, 0, 1]\n"),
      Contains("scene.toml: [garment] grain = [0, 0, 1]: triangle 0 and all triangles connected to it lie at ") &&
          EndsWith("such as grain = [1, 0, 0]"));
  CHECK_NOTHROW(Files().read("grain = [0, 0, 1]\n"));  // the front takes its direction from the sides
}

TEST_CASE("pins name what the garment has, once") {
  const Files files;
  CHECK_THAT(files.errorOf("[[garment.pin]]\nvertices = [0, 8]\n"),
             Contains("[[garment.pin]] number 1: vertex 8: expected 0 to 7, the vertices of"));
  CHECK_THAT(files.errorOf("[[garment.pin]]\nloop = 'top'\n[[garment.pin]]\nvertices = [1, 5]\nto = 'fixed'\n"),
             Contains("[[garment.pin]] number 2: vertex 5 is pinned to the body and in space"));
  CHECK(files.read("[[garment.pin]]\nloop = 'top'\n[[garment.pin]]\nvertices = [1, 5]\n").pins[1] ==
        std::vector<int>{1});
  CHECK_THAT(files.errorOf("[[garment.pin]]\nloop = 'collar'\n"),
             Contains("[[garment.pin]] number 1") && Contains("collar"));
}

TEST_CASE("scans and shirts are read without complaint") {
  if (!std::filesystem::exists(kSharedData)) {
    WARN("skipped: no scans at " << kSharedData);
    return;
  }
  for (const char* name : {"shirt_1100", "shirt_10000"}) {
    const std::filesystem::path scans = std::filesystem::path(kSourceDirectory) / "tests/apps/scans";
    const SceneInput input = readSceneInput(readScene(scans / (std::string(name) + ".toml")));
    CHECK(input.poses.size() == 3);
    CHECK(input.body_triangles.rows() == 55152);
    CHECK(input.warnings.empty());
  }
}

TEST_CASE("a scan numbered otherwise is refused, or matched to the very same positions") {
  if (!std::filesystem::exists(kSharedData)) {
    WARN("skipped: no scans at " << kSharedData);
    return;
  }
  const TemporaryDirectory directory;
  const auto read = [&](const std::string& match) {
    const std::string avatars = std::string(kSharedData) + "/avatars/";
    return readSceneInput(readScene(
        directory.write("scene.toml", "[body]\nposes = ['" + avatars + "slim_t_pose.ply', '" + avatars +
                                          "slim_t_pose_relabelled.ply']\nmatch = '" + match + "'\n[garment]\nmesh = '" +
                                          kSharedData + "/garments/shirt_1100.obj'\n")));
  };
  CHECK_THAT(messageOf<InputError>([&] { read("index"); }),
             Contains("slim_t_pose_relabelled.ply") && Contains("match = \"triangles\""));
  const SceneInput input = read("triangles");
  CHECK((input.poses[1] - input.poses[0]).cwiseAbs().maxCoeff() < 1e-5);
}

TEST_CASE("the built-in T-shirt fits the built-in body's first pose") {
  const SceneInput input = readSceneInput(readScene(std::filesystem::path(kSourceDirectory) / "scenes/t-shirt.toml"));
  CHECK(input.pose_names == std::vector<std::string>{"t", "a", "up"});
  CHECK(std::abs(input.garment.positions.rows() - 2000) <= 60);
  CHECK(input.warnings.empty());
}
