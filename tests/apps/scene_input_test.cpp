#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <sstream>

#include "apps/scene.h"
#include "solver/base/error.h"
#include "tests/apps/temporary_directory.h"
#include "tests/places.h"

using namespace ease;
using Catch::Contains;
using Catch::EndsWith;

namespace {

std::string objText(const TriangleMesh& mesh) {
  std::ostringstream out;
  for (const auto& x : mesh.positions.rowwise()) out << "v " << x << '\n';
  for (const auto& t : mesh.triangles.rowwise()) out << "f " << (t.array() + 1).matrix() << '\n';
  return out.str();
}

/// Makes four walls around the y axis from `low` to `high` and, if `closed`, a floor and a lid:
///
///      6----7
///     /|   /|
///    4----5 |
///    | 2--|-3
///    0----1
TriangleMesh box(double half_width, double low, double high, bool closed) {
  TriangleMesh mesh;
  mesh.positions.resize(8, 3);
  for (int v = 0; v < 8; ++v) {
    const double x = v & 1 ? half_width : -half_width, z = v & 2 ? -half_width : half_width;
    mesh.positions.row(v) << x, (v & 4 ? high : low), z;
  }
  mesh.triangles.resize(closed ? 12 : 8, 3);
  mesh.triangles.topRows(8) << 0, 1, 5, 0, 5, 4, 1, 3, 7, 1, 7, 5, 3, 2, 6, 3, 6, 7, 2, 0, 4, 2, 4, 6;
  if (closed) mesh.triangles.bottomRows(4) << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6;
  return mesh;
}

const TriangleMesh kBody = box(0.2, 0.0, 1.7, true);
const TriangleMesh kGarment = box(0.3, 0.8, 1.4, false);

/// The files of a scene with two poses and a tube around them.  Tests change them.
struct Files {
  Files() {
    write("first.obj", kBody);
    write("second.obj", kBody);
    write("tube.obj", kGarment);
  }
  void write(const std::string& name, const TriangleMesh& mesh) const { directory.write(name, objText(mesh)); }

  SceneInput read(const std::string& more = "", const std::string& body = "") const {
    const std::string toml = "[body]\nposes = ['first.obj', 'second.obj']\n" + body + "[garment]\nmesh = 'tube.obj'\n";
    return readSceneInput(readScene(directory.write("scene.toml", toml + more)));
  }
  SceneInput readWithoutBody(const std::string& more) const {
    const std::string toml = "solver = {steps = 1}\n[garment]\nmesh = 'tube.obj'\n";
    return readSceneInput(readScene(directory.write("scene.toml", toml + more)));
  }
  std::string errorOf(const std::string& more = "", const std::string& body = "") const {
    return messageOf<InputError>([&] { read(more, body); });
  }

  TemporaryDirectory directory;
};

}  // namespace

TEST_CASE("a body and a garment around it are read from beside the scene") {
  const SceneInput input = Files().read("[[garment.pin]]\nloop = 'neck'\n[[garment.pin]]\nvertices = [1, 0]\n");
  CHECK(input.garment.positions == kGarment.positions);
  CHECK(input.garment.triangles == kGarment.triangles);
  CHECK(input.body_triangles == kBody.triangles);
  REQUIRE(input.poses.size() == 2);
  CHECK(input.poses[1] == kBody.positions);
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

TEST_CASE("a body with a hole is refused") {
  const Files files;
  TriangleMesh open = kBody;
  open.triangles.conservativeResize(11, 3);
  files.write("first.obj", open);
  files.write("second.obj", open);
  CHECK_THAT(files.errorOf(), EndsWith("first.obj: 3 boundary edges: expected a closed body, with an inside"));
}

TEST_CASE("a body inside out is refused") {
  const Files files;
  TriangleMesh turned = kBody;
  turned.triangles.col(1).swap(turned.triangles.col(2));
  files.write("first.obj", turned);
  files.write("second.obj", turned);
  CHECK_THAT(files.errorOf(), Contains("first.obj: inside out"));
}

TEST_CASE("a pose of other size than a person's is warned of") {
  const Files files;
  files.write("second.obj", box(0.2, 0.0, 170.0, true));
  const SceneInput input = files.read();
  REQUIRE(input.warnings.size() == 1);
  CHECK_THAT(input.warnings[0], Contains("second.obj: 170 m tall") && Contains("units?"));
}

TEST_CASE("a warning is told before what follows fails") {
  const Files files;
  files.write("first.obj", box(200.0, 0.0, 1700.0, true));
  files.write("second.obj", box(200.0, 0.0, 1700.0, true));
  const std::string toml = "[body]\nposes = ['first.obj', 'second.obj']\n[garment]\nmesh = 'tube.obj'\n";
  std::vector<std::string> told;
  const auto tell = [&](const std::string& warning) { told.push_back(warning); };
  CHECK_THROWS_AS(readSceneInput(readScene(files.directory.write("scene.toml", toml)), tell), InputError);
  REQUIRE(told.size() == 2);
  CHECK_THAT(told[0], Contains("first.obj: 1700 m tall"));
}

TEST_CASE("a limit that was meant as a factor is warned of") {
  const Files files;
  CHECK(files.read("[adaption]\nlimit = 0.5\n").warnings.empty());
  const SceneInput input = files.read("[adaption]\nlimit = 1.08\n");
  REQUIRE(input.warnings.size() == 1);
  CHECK_THAT(input.warnings[0], Contains("scene.toml: [adaption] limit = 1.08: cloth stretched up to 2.08 times"));
}

TEST_CASE("poses numbered differently are refused, or matched by their triangles") {
  const Files files;
  TriangleMesh renumbered = kBody;
  for (int v = 0; v < 8; ++v) renumbered.positions.row(7 - v) = kBody.positions.row(v);
  renumbered.triangles = 7 - kBody.triangles.array();
  files.write("second.obj", renumbered);
  CHECK_THAT(files.errorOf(), Contains("second.obj") && Contains("triangles"));
  CHECK(files.read("", "match = 'triangles'\n").poses[1] == kBody.positions);
}

TEST_CASE("a garment inside the body is refused with how far") {
  const Files files;
  files.write("tube.obj", box(0.15, 0.8, 1.4, false));
  CHECK_THAT(files.errorOf(),
             Contains("tube.obj: 8 of 8 vertices lie inside the first pose, 'first'") && Contains("50.0 mm"));
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

TEST_CASE("a vertex without a triangle is refused") {
  const Files files;
  TriangleMesh loose = kGarment;
  loose.positions.conservativeResize(9, 3);
  loose.positions.row(8) << 0.3, 1.0, 0.3;
  files.write("tube.obj", loose);
  CHECK_THAT(files.errorOf(), Contains("tube.obj: vertex 8 belongs to no triangle"));
}

TEST_CASE("a grain square to a triangle is refused") {
  CHECK_THAT(Files().errorOf("grain = [1, 0, 0]\n"),
             Contains("scene.toml: [garment] grain = [1, 0, 0]: the normal of triangle 2 of tube.obj is parallel"));
  CHECK_NOTHROW(Files().read("grain = [1, 1, 1]\n"));
}

TEST_CASE("pins name what the garment has, once") {
  const Files files;
  CHECK_THAT(files.errorOf("[[garment.pin]]\nvertices = [0, 8]\n"),
             Contains("[[garment.pin]] number 1: vertex 8: expected 0 to 7, the vertices of"));
  CHECK_THAT(files.errorOf("[[garment.pin]]\nloop = 'top'\n[[garment.pin]]\nvertices = [1, 5]\n"),
             EndsWith("[[garment.pin]] number 2: vertex 5 is pinned twice"));
  CHECK_THAT(files.errorOf("[[garment.pin]]\nloop = 'collar'\n"),
             Contains("[[garment.pin]] number 1") && Contains("collar"));
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
