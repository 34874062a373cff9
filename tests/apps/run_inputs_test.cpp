#include "apps/run_inputs.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/apps/temporary_directory.h"

using namespace ease;

namespace {

const std::string kScene =
    "[body]\nposes = ['t.ply', 'a.ply']\n[garment]\nmesh = 's.obj'\n[material]\nbending = 1e-6\n[adaption]\nlimit = "
    "0.09\n";

std::map<std::string, std::string> inputsOf(const TemporaryDirectory& directory, const std::string& scene) {
  return runInputs(readScene(directory.write("scene.toml", scene)));
}

std::string with(std::string scene, const std::string& from, const std::string& to) {
  return scene.replace(scene.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("a run depends on what its scene's tables and mesh files hold, not on how they are written or named") {
  const TemporaryDirectory directory;
  for (const char* name : {"t.ply", "a.ply", "s.obj"}) directory.write(name, name);
  const auto inputs = inputsOf(directory, kScene);
  const auto changed = [&](const std::string& scene) { return differingTables(inputs, inputsOf(directory, scene)); };
  using Names = std::vector<std::string>;
  CHECK(changed(kScene) == Names{});
  CHECK(changed("# a comment\n" + with(kScene, "bending = 1e-6", "bending   = 0.000001  # N m")) == Names{});
  CHECK(changed(kScene + "[output]\nevery = 4\n[pattern]\ndarts = false\n[solver]\nthreads = 1\n") ==
        Names{"[solver]"});
  CHECK(changed(with(kScene, "mesh", "grain = [1, 0, 0]\nmesh")) == Names{"[garment]"});
  CHECK(changed(with(kScene, "1e-6", "1e-5")) == Names{"[material]"});
  CHECK(changed(with(with(kScene, "0.09", "0.08"), "'a.ply'", "'s.obj'")) == Names{"[adaption]", "[body]"});
  CHECK(changed(with(kScene, "[material]", "[[garment.seam]]\nname = 'side'\nfrom = 'hem'\nto = 'neck'\n[material]")) ==
        Names{});

  std::filesystem::rename(directory.path / "a.ply", directory.path / "b.ply");
  CHECK(changed(with(kScene, "a.ply", "b.ply")) == Names{});
  directory.write("b.ply", "another body");
  CHECK(changed(with(kScene, "a.ply", "b.ply")) == Names{"[body]"});
}
