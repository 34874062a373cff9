// Damaged scenes and meshes: each is refused by one clear line or does what it says; none crashes or hangs.
//
// EASE_FUZZ_ROUNDS=20000 build/release/tests/fuzz/test_fuzz tries more of them than the few hundred of a test.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <sstream>

#include "apps/job.h"
#include "apps/scene.h"
#include "apps/scene_run.h"
#include "solver/base/error.h"
#include "solver/io/mesh_io.h"
#include "solver/mesh/mesh_checks.h"
#include "solver/mesh/topology.h"
#include "tests/apps/temporary_directory.h"
#include "tests/collision/bodies.h"
#include "tests/fuzz/mutate.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

int rounds(int usual) {
  const char* asked = std::getenv("EASE_FUZZ_ROUNDS");
  return asked ? std::atoi(asked) : usual;
}

std::string contentOf(const std::filesystem::path& file) {
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return content.str();
}

/// What kind of end `attempt` has: "" where it succeeds, the message where the input is refused or cannot be computed.
template <class Attempt>
std::string outcomeOf(const Attempt& attempt) {
  try {
    attempt();
  } catch (const InputError& error) {
    return error.what();
  } catch (const ComputationError& error) {
    return error.what();
  }
  return "";
}

void checkOneLine(const std::string& message) {
  CHECK(message.find('\n') == std::string::npos);
  CHECK(message.size() < 2000);
}

const std::string kScene = R"(name = "tube"
[body]
poses = ["low.obj", "high.obj"]
steps = 3
[garment]
mesh = "sheet.obj"
grain = [0, -1, 0]
[[garment.pin]]
vertices = [0, 5]
to = "fixed"
[material]
density = 0.15
stretch = [800, 700]
shear = 200
bending = 1e-6
damping = { stretch = 1, shear = 1, bending = 1e-6 }
[solver]
method = "auto"
time_step = 0.0025
steps_per_pose = 2
gravity = [0, -9.81, 0]
[collision]
offset = 0.005
voxel = 0.01
[adaption]
mode = 'sequential'
limit = 0.1
every = 2
cycles = 1
verify = false
[output]
every = 2
)";

}  // namespace

TEST_CASE("a damaged scene is refused in one line, or runs") {
  ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null", 1);  // no pictures, which take longer than all the rest
  const TemporaryDirectory directory;
  const TriangleMesh ball = bodies::sphere(0.1, 3);
  writeObj(directory.path / "low.obj", ball);
  writeObj(directory.path / "high.obj", bodies::moved(ball, Vec3(0.0, 0.01, 0.0)));
  writeObj(directory.path / "sheet.obj", makeSheet(4, 4, 0.1, 0.1));
  TriangleMesh sheet = makeSheet(4, 4, 0.1, 0.1);
  sheet.positions.col(2).array() += 0.12;
  writeObj(directory.path / "sheet.obj", sheet);

  int ran = 0;
  const int count = rounds(300);
  for (int k = 0; k <= count; ++k) {
    const std::string toml = k == 0 ? kScene : Mutator(k).damaged(kScene);
    const std::filesystem::path file = directory.write("scene.toml", toml);
    INFO("seed " << k << "\n" << toml);
    bool runs = false;
    const std::string message = outcomeOf([&] {
      const Scene scene = readScene(file);
      const SceneInput input = readSceneInput(scene);
      const int cycles = scene.adaption ? scene.adaption->cycles : 1;
      if (static_cast<long>(timeStepsOfMotion(replaySchedule(scene))) * cycles > 40 || scene.collision.voxel < 2e-3)
        return;
      runs = true;
      std::atomic<bool> interrupted = false;
      runScene(scene, input, directory.path / "results", interrupted, std::chrono::steady_clock::now());
    });
    checkOneLine(message);
    ran += runs ? 1 : 0;
    if (k == 0) REQUIRE(message.empty());
  }
  CHECK(ran > count / 30);
}

TEST_CASE("a damaged mesh is refused in one line, or read") {
  const TemporaryDirectory directory;
  const TriangleMesh ball = bodies::sphere(0.1, 2);
  const auto writtenAs = [&](const std::string& name) -> std::string {
    std::ostringstream out;
    if (name == "mesh.ply") {
      out << "ply\nformat ascii 1.0\nelement vertex " << ball.positions.rows()
          << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << ball.triangles.rows()
          << "\nproperty list uchar int vertex_indices\nend_header\n";
      for (const auto& x : ball.positions.rowwise()) out << x << '\n';
      for (const auto& t : ball.triangles.rowwise()) out << "3 " << t << '\n';
      return out.str();
    }
    if (name == "mesh.stl") {
      out << "solid ball\n";
      for (const auto& t : ball.triangles.rowwise()) {
        out << "facet normal 0 0 0\nouter loop\n";
        for (int a = 0; a < 3; ++a) out << "vertex " << ball.positions.row(t[a]) << '\n';
        out << "endloop\nendfacet\n";
      }
      out << "endsolid ball\n";
      return out.str();
    }
    writeObj(directory.path / name, ball);
    return contentOf(directory.path / name);
  };
  const std::string name = GENERATE("mesh.obj", "mesh.ply", "mesh.stl");
  const std::string whole = writtenAs(name);
  int read = 0;
  const int count = rounds(300);
  for (int k = 0; k <= count; ++k) {
    const std::filesystem::path file = directory.write(name, k == 0 ? whole : Mutator(k).damaged(whole));
    INFO(name << ", seed " << k);
    const std::string message = outcomeOf([&] {
      const TriangleMesh mesh = readMesh(file);
      checkGeometry(mesh, name);
      checkVerticesUsed(mesh, name);
      buildTopology(mesh, name);
    });
    checkOneLine(message);
    read += message.empty() ? 1 : 0;
    if (k == 0) REQUIRE(message.empty());
  }
  CHECK(read > 0);
  CHECK(read < count);
}
