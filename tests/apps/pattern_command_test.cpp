// Tests of `ease pattern` and of what `ease check` says of patterns (apps/pattern_command.cpp, apps/pattern_check.cpp).
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/apps/command.h"

using namespace ease;
using Catch::Contains;

namespace {

/// A tube of cloth around the mannequin's trunk that is held for a few steps, with seams at both sides.
const std::string kTube =
    "body = {builtin = 'mannequin', poses = ['t'], steps = 4}\nsolver = {steps_per_pose = 1}\n"
    "[garment]\nresolution = 400\n[garment.region]\nseed = [0, 1, 0.2]\n"
    "[[garment.boundary]]\nname = 'top'\nplane = {point = [0, 1.2, 0], normal = [0, 1, 0]}\n"
    "[[garment.boundary]]\nname = 'hem'\nplane = {point = [0, 0.9, 0], normal = [0, 1, 0], near = [0, 0.9, 0.1]}\n";
const std::string kSides =
    "[[garment.seam]]\nname = 'left'\nfrom = 'hem'\nto = 'top'\npoints = [[0.15, 1.05, 0]]\n"
    "[[garment.seam]]\nname = 'right'\nfrom = 'hem'\nto = 'top'\npoints = [[-0.15, 1.05, 0]]\n";

}  // namespace

TEST_CASE("pattern runs a scene, writes its pattern and how the garment sewn from it differs") {
  const TemporaryDirectory directory;
  directory.write("tube.toml", kTube + kSides);
  const Outcome made = runEase(directory, "pattern tube.toml -o made");
  INFO(made.err);
  REQUIRE(made.code == 0);
  for (const char* name :
       {"pattern.svg", "pattern.pdf", "pattern_a4.pdf", "pattern.dxf", "pattern.json", "pattern.vtp", "rest_shape.vtp"})
    CHECK(std::filesystem::file_size(directory.path / "made" / name) > 0);
  const auto report = nlohmann::json::parse(contentOf(directory.path / "made/report.json")).at("pattern");
  CHECK(report.at("pieces").size() == 2);
  CHECK(report.at("pieces")[0].at("flipped") == 0);
  CHECK(report.at("seams").size() == 2);
  for (const auto& seam : report.at("seams")) CHECK(seam.at("difference_mm").get<double>() < 0.01);
  CHECK(report.at("resewn").at("rms_mm").get<double>() < 6.0);
  CHECK(report.at("cloth_m2").get<double>() > 0.2);

  // The pattern of the finished run, written elsewhere, without simulating it again.
  const Outcome again = runEase(directory, "pattern made -o again");
  REQUIRE(again.code == 0);
  CHECK_THAT(again.out, !Contains("the scene is run first"));
  CHECK(contentOf(directory.path / "again/pattern.svg") == contentOf(directory.path / "made/pattern.svg"));

  // A scene that has changed since is not that run's.
  directory.write("tube.toml", kTube + kSides + "[material]\ndensity = 0.3\n");
  const Outcome changed = runEase(directory, "pattern tube.toml -o made");
  CHECK(changed.code == 1);
  CHECK(isOneLine(changed.err));
  CHECK_THAT(changed.err, Contains("made: this run was made with another [material] than the scene has now"));
}

TEST_CASE("the pattern of a garment whose file has it in pieces names the vertices of that file") {
  const TemporaryDirectory directory;
  directory.write("tube.toml", kTube + kSides);
  REQUIRE(runEase(directory, "garment tube.toml --pieces -o garment").code == 0);
  std::string sides = kSides;
  for (size_t at = sides.find("'top'"); at != std::string::npos; at = sides.find("'top'"))
    sides.replace(at, 5, "'neck'");
  directory.write("split.toml",
                  "body = {builtin = 'mannequin', poses = ['t'], steps = 4}\nsolver = {steps_per_pose = 1}\n"
                  "[garment]\nmesh = 'garment/pieces.obj'\n" +
                      sides + "[pattern]\ncheck = false\nformats = ['json']\n");
  const Outcome made = runEase(directory, "pattern split.toml -o made");
  INFO(made.err);
  REQUIRE(made.code == 0);
  const std::string pieces = contentOf(directory.path / "garment/pieces.obj");
  std::vector<std::array<double, 3>> vertices;
  std::istringstream lines(pieces);
  for (std::string line; std::getline(lines, line);)
    if (std::array<double, 3> x{}; std::sscanf(line.c_str(), "v %lf %lf %lf", &x[0], &x[1], &x[2]) == 3)
      vertices.push_back(x);
  const auto pattern = nlohmann::json::parse(contentOf(directory.path / "made/pattern.json"));
  int on_hem = 0;
  for (const auto& outline : pattern.at("outlines"))
    for (const auto& edge : outline.at("edges"))
      if (edge.at("name") == "hem")
        for (const int v : edge.at("garment_vertex")) {
          CHECK(vertices.at(v)[1] == Approx(0.9).margin(0.01));
          ++on_hem;
        }
  CHECK(on_hem > 20);
}

TEST_CASE("pattern finds seams where a scene has none") {
  const TemporaryDirectory directory;
  directory.write("tube.toml", kTube + "[pattern]\ncheck = true\n");
  const Outcome made = runEase(directory, "pattern tube.toml -o made");
  INFO(made.err);
  REQUIRE(made.code == 0);
  CHECK_THAT(made.out, Contains("cuts      found in"));
  const auto report = nlohmann::json::parse(contentOf(directory.path / "made/report.json")).at("pattern");
  CHECK(report.at("cuts").at("energy") <= report.at("cuts").at("energy_at_start"));
  CHECK(report.at("pieces").size() >= 1);
  CHECK(report.at("resewn").at("rms_mm").get<double>() < 8.0);
}

TEST_CASE("pattern says in a line what it lacks") {
  const TemporaryDirectory directory;
  directory.write("seamless.toml", kTube + "[pattern.cuts]\nmethod = 'none'\n");
  const Outcome seamless = runEase(directory, "pattern seamless.toml");
  CHECK(seamless.code == 1);
  CHECK(isOneLine(seamless.err));
  CHECK_THAT(seamless.err, Contains("has no [[garment.seam]] and [pattern.cuts] method = 'none'"));

  const Outcome empty = runEase(directory, "pattern .");
  CHECK(empty.code == 1);
  CHECK(isOneLine(empty.err));
  CHECK_THAT(empty.err, Contains("no finished run"));

  directory.write("narrow.toml", kTube + kSides + "[pattern]\nfabric_width = 0.2\ncheck = false\n");
  const Outcome narrow = runEase(directory, "pattern narrow.toml");
  CHECK(narrow.code == 1);
  CHECK(isOneLine(narrow.err));
  CHECK_THAT(narrow.err, Contains("narrow.toml: [pattern] fabric_width = 0.2: piece '") && Contains("wide"));
  CHECK_THAT(narrow.out, !Contains("the scene is run first"));

  directory.write("hemm.toml", kTube + kSides + "[pattern]\ncheck = false\n[pattern.allowance]\nhemm = 0.03\n");
  const Outcome hemm = runEase(directory, "pattern hemm.toml");
  CHECK(hemm.code == 1);
  CHECK(isOneLine(hemm.err));
  CHECK_THAT(hemm.err, Contains("[pattern] allowance.hemm: no piece has such a seam or edge; did you mean 'hem'?"));
}

TEST_CASE("a scene's pattern is checked where it has one, before anything is simulated") {
  const TemporaryDirectory directory;
  for (const auto& [pattern, message] : std::vector<std::pair<std::string, std::string>>{
           {"[pattern]\nfabric_width = 0.2\n", "[pattern] fabric_width = 0.2: piece '"},
           {"[pattern.allowance]\nhemm = 0.03\n", "[pattern] allowance.hemm: no piece has such a seam or edge"},
           {"[[pattern.piece]]\nname = 'front'\nat = [0, 9, 0]\n", "[pattern] piece 'front'"},
           {"[pattern.cuts]\nsymmetric = 3\n", "[pattern.cuts] symmetric = 3: the plane misses the garment"}}) {
    directory.write("scene.toml", kTube + kSides + pattern);
    const Outcome outcome = runEase(directory, "check scene.toml");
    INFO(pattern);
    CHECK(outcome.code == 1);
    CHECK(isOneLine(outcome.err));
    CHECK_THAT(outcome.err, Contains(message));
  }
  directory.write("scene.toml", kTube + kSides + "[pattern.allowance]\nhem = 0.03\n");
  CHECK(runEase(directory, "check scene.toml").code == 0);
  directory.write("scene.toml", kTube + kSides);  // it need not have one
  CHECK(runEase(directory, "check scene.toml").code == 0);
}
