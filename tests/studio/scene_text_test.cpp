#include "apps/studio/scene_text.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "apps/studio/document.h"
#include "apps/studio/parts.h"
#include "solver/base/error.h"
#include "tests/places.h"

namespace ease {
namespace {

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// Whether all lines of `part` occur in `whole` in the same order.
bool isWithin(const std::vector<std::string>& part, const std::vector<std::string>& whole) {
  size_t k = 0;
  for (const std::string& line : whole)
    if (k < part.size() && part[k] == line) ++k;
  return k == part.size();
}

constexpr const char* kText = R"([body]
poses = ["t.ply"]   # one

[[garment.boundary]]  # the first
name = "neck"       # at the top
points = [
  [0.1, 0.2, 0.3],
  [0.4, 0.5, 0.6]   # the last row
]
plane = { point = [0, 1, 0], normal = [0, 1, 0] }

[[garment.boundary]]
name = "hem [low] # no comment"

# About the region.
[garment.region]
seed = [0, 1, 0]
)";

TEST_CASE("rows of an array are no headers, and brackets in strings count for nothing") {
  const SceneText text(kText);
  CHECK(text.count("garment.boundary") == 2);
  CHECK(text.value("garment.boundary", 1, "name") == "\"hem [low] # no comment\"");
  CHECK(text.value("garment.boundary", 0, "points").substr(0, 3) == "[\n ");
  CHECK(text.value("garment.boundary", 0, "points").back() == ']');
  CHECK(text.value("garment.region", 0, "seed") == "[0, 1, 0]");
}

TEST_CASE("a value is replaced and the comment behind it stays in its column") {
  SceneText text(kText);
  text.setValue("garment.boundary", 0, "name", "\"collar\"");
  CHECK(text.text().find("name = \"collar\"     # at the top\n") != std::string::npos);
  text.setValue("garment.boundary", 0, "points", "[[1, 2, 3]]");
  CHECK(text.value("garment.boundary", 0, "points") == "[[1, 2, 3]]");
  CHECK(text.value("garment.boundary", 0, "plane") == "{ point = [0, 1, 0], normal = [0, 1, 0] }");
}

TEST_CASE("an entry is added below the last of its kind and removed without a trace") {
  SceneText text(kText);
  text.addEntry("garment.boundary", {{"name", "\"waist\""}});
  CHECK(text.count("garment.boundary") == 3);
  CHECK(text.text().find("waist") < text.text().find("# About the region"));
  text.removeEntry("garment.boundary", 2);
  CHECK(text.text() == kText);
  text.removeEntry("garment.boundary", 0);
  CHECK(text.value("garment.boundary", 0, "name") == "\"hem [low] # no comment\"");
}

TEST_CASE("line ends and a missing one at the end of the file are kept") {
  SceneText text("[body]\r\nposes = [\"t\"]");
  text.addEntry("garment.pin", {{"loop", "\"top\""}});
  CHECK(text.text() == "[body]\r\nposes = [\"t\"]\r\n\r\n[[garment.pin]]\r\nloop = \"top\"\r\n");
}

TEST_CASE("numbers are written with a leading digit and no more digits than needed") {
  CHECK(tomlNumber(0.5) == "0.5");
  CHECK(tomlNumber(-0.25) == "-0.25");
  CHECK(tomlNumber(3.0) == "3.0");
  CHECK(tomlNumber(-1e-9) == "0.0");
  CHECK(tomlText("a \"b\" \\") == "\"a \\\"b\\\" \\\\\"");
}

/// All gestures that a scene's garment allows, as texts.
std::vector<std::string> gesturesOn(const std::string& text, const Scene& scene) {
  const std::vector<Vec3> stroke = {{0.0, 1.2, 0.12}, {0.05, 1.2, 0.12}};
  std::vector<std::string> edits = {withPaint(text, stroke, 0.1, 1.2), withComfort(text, {stroke.front()}, 0.1, 0.02),
                                    withPinnedBall(text, stroke.front(), 0.05)};
  if (scene.garment.tools) {
    edits.push_back(withBoundary(text, "cuff", {{0, 1, 0}, {0, 1, 1}, {1, 1, 0}}));
    edits.push_back(withRegion(text, {0, 1, 0.1}));
    const std::string& loop = scene.garment.tools->boundaries.front().name;
    edits.push_back(withExtension(text, -1, loop, 0.2, 1.1));
    edits.push_back(withPinnedLoop(text, loop));
    edits.push_back(withSeam(text, "new seam", loop, loop, stroke));
  }
  return edits;
}

TEST_CASE("on every scene each gesture leaves all other lines to the byte, and undo gives them back") {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(kSourceDirectory) / "scenes")) {
    if (entry.path().extension() != ".toml") continue;
    ++scenes;
    CAPTURE(entry.path());
    const std::string text = contentOf(entry.path());
    const Scene scene = readDraft(text, entry.path());
    for (const std::string& edited : gesturesOn(text, scene)) {
      CAPTURE(edited);
      CHECK(edited != text);
      if (edited.find("seed = [0.0, 1.0, 0.1]") == std::string::npos) CHECK(isWithin(linesOf(text), linesOf(edited)));
      CHECK_NOTHROW(readScene(entry.path()));
      CHECK_NOTHROW(readDraft(edited, entry.path()));
    }
    for (const Part& part : partsOf(scene)) {
      const std::string removed = without(text, part);
      CHECK(isWithin(linesOf(removed), linesOf(text)));
      CHECK(partsOf(readDraft(removed, entry.path())).size() < partsOf(scene).size());
    }
  }
  CHECK(scenes >= 4);
}

TEST_CASE("a renamed boundary is renamed wherever it is named") {
  const std::filesystem::path file = std::filesystem::path(kSourceDirectory) / "scenes" / "tunic.toml";
  const std::string text = contentOf(file);
  const Scene scene = readDraft(text, file);
  const std::vector<Part> parts = partsOf(scene);
  const auto hem = std::find_if(parts.begin(), parts.end(), [](const Part& part) { return part.label == "hem"; });
  REQUIRE(hem != parts.end());
  const std::string edited = renamed(text, scene, *hem, "lower edge");
  const Scene after = readDraft(edited, file);
  CHECK(after.garment.tools->boundaries[hem->number].name == "lower edge");
  CHECK(after.garment.tools->seams.front().from == "lower edge");
  CHECK(renamed(edited, after, {PartKind::boundary, hem->number, "lower edge"}, "hem") == text);
}

}  // namespace
}  // namespace ease
