#include <algorithm>
#include <catch2/catch.hpp>

#include "apps/scene.h"
#include "solver/base/error.h"
#include "tests/apps/temporary_directory.h"

using namespace ease;
using Catch::Contains;
using Catch::EndsWith;

namespace {

const std::string kBody = "body = {builtin = 'mannequin', poses = ['t']}\n";

// Scene of a tube around the mannequin's trunk.  Tests append lines to it.
const std::string kTube =
    kBody +
    "[garment]\nresolution = 400\n[garment.region]\nseed = [0, 1, 0.2]\n"
    "[[garment.boundary]]\nname = 'top'\nplane = {point = [0, 1.2, 0], normal = [0, 1, 0]}\n"
    "[[garment.boundary]]\nname = 'hem'\nplane = {point = [0, 0.9, 0], normal = [0, 1, 0], near = [0, 0.9, 0.1]}\n";

Scene sceneOf(const std::string& toml) {
  const TemporaryDirectory directory;
  return readScene(directory.write("scene.toml", toml));
}

SceneInput inputOf(const std::string& toml) {
  const TemporaryDirectory directory;
  return readSceneInput(readScene(directory.write("scene.toml", toml)));
}

std::string errorOf(const std::string& toml) {
  const std::string message = messageOf<InputError>([&] { inputOf(toml); });
  CHECK(message.find('\n') == std::string::npos);
  return message;
}

}  // namespace

TEST_CASE("the tools are read as they are written") {
  const Scene scene = sceneOf(kTube +
                              "[[garment.extension]]\nloop = 'hem'\nlength = 0.4\nscale = 1.6\n"
                              "[[garment.paint]]\nat = [0, 1, 0.1]\nradius = 0.1\nscale = 1.3\n"
                              "[garment.comfort]\noffset = 0.004\n"
                              "[[garment.comfort.region]]\nat = [0, 1.1, 0.1]\nradius = 0.2\noffset = 0.03\n"
                              "[[garment.seam]]\nname = 'side'\nfrom = 'hem'\nto = 'top'\npoints = [[0.1, 1, 0]]\n");
  REQUIRE(scene.garment.tools);
  const GarmentTools& tools = *scene.garment.tools;
  CHECK(tools.resolution == 400);
  CHECK(tools.seed == Vec3(0, 1, 0.2));
  REQUIRE(tools.boundaries.size() == 2);
  CHECK(tools.boundaries[0].name == "top");
  CHECK(tools.boundaries[0].plane->near == Vec3(0, 1.2, 0));
  CHECK(tools.boundaries[1].plane->near == Vec3(0, 0.9, 0.1));
  REQUIRE(tools.extensions.size() == 1);
  CHECK(tools.extensions[0].length == 0.4);
  CHECK_FALSE(tools.extensions[0].to);
  REQUIRE(scene.garment.paint.size() == 1);
  CHECK(scene.garment.paint[0].value == 1.3);
  CHECK(scene.collision.offset == 0.004);
  CHECK(scene.garment.comfort_regions[0].value == 0.03);
  CHECK(tools.seams[0].points == std::vector<Vec3>{{0.1, 1, 0}});
}

TEST_CASE("a garment that is made has its loops by name, offsets, paint and pins") {
  const SceneInput input =
      inputOf(kTube +
              "[[garment.pin]]\nloop = 'top'\n[[garment.pin]]\nat = [0, 0.9, 0.15]\nradius = 0.05\n"
              "[[garment.paint]]\nat = [0, 1, 0.12]\nradius = 0.1\nscale = 1.2\n");
  REQUIRE(input.authored);
  CHECK(std::abs(input.garment.positions.rows() - 400) <= 12);
  CHECK(input.pins[0] == input.authored->garment.loops[0].vertices);
  CHECK_FALSE(input.pins[1].empty());
  for (const int v : input.pins[1]) CHECK((Vec3(input.garment.positions.row(v)) - Vec3(0, 0.9, 0.15)).norm() <= 0.05);
  CHECK(std::all_of(input.offsets.begin(), input.offsets.end(), [](double offset) { return offset == 0.005; }));
  CHECK(*std::max_element(input.paint.begin(), input.paint.end()) > 1.1);
}

TEST_CASE("flaws of a garment that is made are warned of") {
  CHECK(inputOf(kTube).warnings.empty());
  const SceneInput input = inputOf(kTube + "[[garment.extension]]\nloop = 'hem'\nto = [0, 1.1, 0]\n");
  REQUIRE_FALSE(input.warnings.empty());
  CHECK_THAT(input.warnings[0], Contains("scene.toml: [garment] as made: ") && EndsWith("cross each other"));
}

TEST_CASE("a wrong tool is one line with what was expected") {
  const auto [more, message] = GENERATE(table<const char*, const char*>({
      {"[[garment.boundary]]\nname = 'top'\npoints = [[0, 0, 0]]\n", "name = 'top': expected a name that no other"},
      {"[[garment.boundary]]\nname = 'cuff'\n", "points is missing: expected one of points, vertices and plane"},
      {"[[garment.boundary]]\nname = 'cuff'\npoints = [[0, 0]]\n",
       "points = [[0, 0]]: expected an array of arrays of 3"},
      {"[[garment.boundary]]\nname = 'cuff'\npoints = [0, 0, 0]\n", "entry 1 is 0"},
      {"[[garment.boundary]]\nname = 'cuff'\nplane = {point = [0, 0, 0], normal = [0, 0, 0]}\n",
       "a direction, not zero"},
      {"[[garment.boundary]]\nname = 'cuff'\nplane = {point = [0, 3, 0], normal = [0, 1, 0]}\n",
       "[garment] boundary 'cuff': its plane does not cut the body"},
      {"[[garment.boundary]]\nname = 'cuff'\npoints = [[0, 0, 0.6], [0, 1, 1], [0, 1, 0]]\n",
       "[garment] boundary 'cuff': point 0 = [0, 0, 0.6] is"},
      {"[garment.comfort.region]\n", "[[garment.comfort.region]], in double brackets"},
      {"[[garment.comfort.region]]\nat = [0, 9, 0]\nradius = 0.1\noffset = 0.02\n",
       "[garment] comfort.region number 1: at = [0, 9, 0], radius = 0.1: touches no vertex"},
      {"[[garment.extension]]\nloop = 'cuff'\nlength = 0.1\n", "loop = 'cuff': expected one of 'top', 'hem'"},
      {"[[garment.extension]]\nloop = 'hem'\n", "length is missing: expected either to, a point, or length"},
      {"[[garment.paint]]\nat = [0, 1, 0]\nradius = 0.1\n", "[[garment.paint]] scale is missing"},
      {"[[garment.paint]]\nat = [0, 9, 0]\nradius = 0.1\nscale = 2\n", "paint number 1: at = [0, 9, 0]"},
      {"[garment.comfort]\noffset = 0.5\n", "offset = 0.5: expected a number from 0 to 0.1 m"},
      {"[garment.comfort]\noffset = 0.01\n[collision]\noffset = 0.01\n",
       "expected either this or [garment.comfort] offset"},
      {"[[garment.pin]]\nloop = 'neck'\n", "loop = 'neck': expected one of 'top', 'hem'"},
      {"[[garment.pin]]\nat = [0, 5, 0]\nradius = 0.1\n", "no vertex of the garment lies in this ball"},
      {"[[garment.seam]]\nname = 'side'\nfrom = 'hem'\n", "from = 'hem': expected to as well"},
      {"[[garment.seam]]\nname = 'side'\nfrom = 'hem'\nto = 'cuff'\n", "seam 'side': loop 'cuff': expected one of"},
      {"[[garment.seam]]\nname = 'side'\nform = 'hem'\n", "'form' is not a known key; did you mean 'from'?"},
  }));
  INFO(more);
  CHECK_THAT(errorOf(kTube + more), Contains("scene.toml") && Contains(message));
}

TEST_CASE("tools without boundaries, without a body or beside a finished garment are refused") {
  CHECK_THAT(errorOf("solver = {steps = 1}\n[garment]\nmesh = 's.obj'\nresolution = 3000\n"),
             Contains("resolution = 3000: expected [[garment.boundary]] loops for 'resolution'"));
  CHECK_THAT(errorOf("solver = {steps = 1}\n[[garment.boundary]]\nname = 'top'\nvertices = [1, 2, 3]\n"),
             EndsWith(":2: [garment] boundary: expected a [body] in this scene, which it needs"));
  CHECK_THAT(errorOf(kBody + "[garment]\nmesh = 's.obj'\n[[garment.boundary]]\nname = 'a'\nvertices = [1, 2, 3]\n"),
             Contains("mesh = 's.obj': expected either this or [[garment.boundary]] loops"));
  CHECK_THAT(errorOf(kBody + "[[garment.boundary]]\nname = 'a'\nvertices = [1, 2, 3]\n"),
             EndsWith("expected a table [garment.region] with a seed, since there are boundaries"));
}

TEST_CASE("paint and comfort take a stroke's points in place of a ball's middle") {
  const Scene scene = sceneOf(kTube +
                              "[[garment.paint]]\npoints = [[0, 1, 0.1], [0.1, 1, 0.1]]\nradius = 0.1\nscale = 1.2\n"
                              "[[garment.comfort.region]]\npoints = [[0, 1, 0.1]]\nradius = 0.1\noffset = 0.02\n");
  REQUIRE(scene.garment.paint.size() == 1);
  CHECK(scene.garment.paint.front().stroke.size() == 2);
  CHECK(scene.garment.paint.front().at == Vec3(0, 1, 0.1));
  CHECK(scene.garment.comfort_regions.front().stroke.size() == 1);
  CHECK_THAT(errorOf(kTube + "[[garment.paint]]\npoints = [[0, 1, 0]]\nat = [0, 1, 0]\nradius = 0.1\nscale = 1.2\n"),
             Contains("either at, a ball, or points, a stroke, not both"));
}

TEST_CASE("a draft may lack a garment or a region, which a scene may not") {
  const std::string body = "[body]\nbuiltin = 'mannequin'\nposes = ['t']\n";
  CHECK(readDraft(body, "new.toml").garment.is_draft);
  const std::string loop = "[[garment.boundary]]\nname = 'a'\nvertices = [1, 2, 3]\n";
  CHECK(readDraft(body + loop, "new.toml").garment.tools->boundaries.size() == 1);
  CHECK(readDraft(body + loop, "new.toml").garment.is_draft);
  CHECK_FALSE(readDraft(body + loop + "[garment.region]\nseed = [0, 1, 0]\n", "new.toml").garment.is_draft);
  CHECK_THAT(messageOf<InputError>([&] { readDraft(body + "[garment]\ncolour = 3\n", "new.toml"); }),
             Contains("'colour' is not a known key"));
}
