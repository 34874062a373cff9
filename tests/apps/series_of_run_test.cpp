#include "apps/series_of_run.h"

#include <catch2/catch.hpp>
#include <string>

#include "tests/apps/command.h"
#include "tests/apps/scene_files.h"
#include "tests/apps/temporary_directory.h"

namespace ease {

namespace {

namespace fs = std::filesystem;

/// The moments that a .pvd lists, with the name of each frame after its series' name.
std::string framesOf(const fs::path& pvd) {
  INFO(pvd.string());
  REQUIRE(fs::exists(pvd));
  std::string frames, text = contentOf(pvd);
  for (size_t at = text.find("timestep="); at != std::string::npos; at = text.find("timestep=", at + 1))
    frames += text.substr(at, text.find('"', at + 10) - at) + '\n';
  return frames;
}

void run(const TemporaryDirectory& directory, const std::string& scene) {
  const Outcome outcome = runEase(directory, "run " + scene + ".toml -o " + scene);
  INFO(outcome.err);
  REQUIRE(outcome.code != 1);
  REQUIRE(outcome.code != 2);
}

}  // namespace

TEST_CASE("replays are written as series of their own, with as many frames as the motion has") {
  const Files files;
  const TemporaryDirectory& directory = files.directory;
  const std::string scene =
      "[body]\nposes = ['first.obj', 'second.obj']\nsteps = 4\n[garment]\nmesh = 'tube.obj'\n[solver]\n"
      "steps_per_pose = 1\n[output]\nevery = 2\nreplays = true\n[adaption]\nlimit = 0.1\n";
  directory.write("sequential.toml", scene + "mode = 'sequential'\ncycles = 2\n");
  run(directory, "sequential");
  const std::string before = framesOf(directory.path / "sequential/before_garment.pvd");
  CHECK(before.find("0.01") != std::string::npos);
  CHECK(before == framesOf(directory.path / "sequential/after_garment.pvd"));
  CHECK(before == framesOf(directory.path / "sequential/before_body.pvd"));
  CHECK(framesOf(directory.path / "sequential/garment.pvd").size() > before.size());
  CHECK_FALSE(fs::exists(directory.path / "sequential/before_rest.pvd"));

  directory.write("passes.toml", scene + "passes = 1\n");
  run(directory, "passes");
  CHECK(framesOf(directory.path / "passes/before_garment.pvd") == framesOf(directory.path / "passes/garment.pvd"));
  CHECK_FALSE(fs::exists(directory.path / "passes/after_garment.pvd"));
}

TEST_CASE("a run without replays leaves none of an earlier one") {
  const Files files;
  const TemporaryDirectory& directory = files.directory;
  const std::string scene =
      "[body]\nposes = ['first.obj', 'second.obj']\nsteps = 2\n[garment]\nmesh = 'tube.obj'\n[solver]\n"
      "steps_per_pose = 1\n[adaption]\npasses = 1\n[output]\nevery = 1\n";
  directory.write("box.toml", scene + "replays = true\n");
  run(directory, "box");
  REQUIRE(fs::exists(directory.path / "box/before_body.pvd"));
  directory.write("box.toml", scene);
  run(directory, "box");
  CHECK_FALSE(fs::exists(directory.path / "box/before_body.pvd"));
  CHECK_FALSE(fs::exists(directory.path / "box/before_garment.pvd"));
}

}  // namespace ease
