#include "apps/scene.h"

#include <catch2/catch.hpp>

#include "solver/mesh/error.h"
#include "tests/apps/temporary_directory.h"

using namespace ease;
using Catch::Contains;
using Catch::EndsWith;
using Catch::StartsWith;

namespace {

Scene sceneOf(const std::string& toml) {
  const TemporaryDirectory directory;
  return readScene(directory.write("scene.toml", toml));
}

/// The error for a scene, from its file's name on: "scene.toml:LINE: ...".
std::string errorOf(const std::string& toml) {
  const std::string message = messageOf<InputError>([&] { sceneOf(toml); });
  CHECK(message.find('\n') == std::string::npos);
  const size_t name = message.find("scene.toml");
  return name == std::string::npos ? message : message.substr(name);
}

// Smallest scenes, to which the tests add lines; one line each, so that what is added begins on the second.
const std::string kBody = "body = {poses = ['t.ply', 'a.ply']}\n[garment]\nmesh = 's.obj'\n";
const std::string kNoBody = "solver = {steps = 10}\n[garment]\nmesh = 's.obj'\n";

}  // namespace

TEST_CASE("the smallest scene has the defaults") {
  const Scene scene = sceneOf(kBody);
  CHECK(scene.name == "scene");
  REQUIRE(scene.body);
  CHECK(scene.body->poses == std::vector<std::string>{"t.ply", "a.ply"});
  CHECK(scene.body->steps == 60);
  CHECK_FALSE(scene.body->match_triangles);
  CHECK(scene.garment.grain == Vec3(0.0, -1.0, 0.0));
  CHECK(scene.garment.pins.empty());
  CHECK(scene.material.density == 0.15);
  CHECK_FALSE(scene.material.total_mass);
  CHECK(scene.material.bending == 0.0);
  CHECK(scene.solver.method == "auto");
  CHECK(scene.solver.time_step == 0.0025);
  CHECK(scene.solver.steps_per_pose == 4);
  CHECK(scene.collision.offset == 0.005);
  CHECK_FALSE(scene.adaption);
  CHECK_FALSE(scene.output);
  CHECK(timeStepsOfMotion(scene) == 240);
}

TEST_CASE("every key of a scene is read") {
  const Scene scene = sceneOf(R"(
name = "t-shirt"
[body]
poses = ["t.ply", "a.ply", "up.ply"]
steps = 50
match = "triangles"
[garment]
mesh = "shirt.obj"
grain = [0, -2, 0]
[[garment.pin]]
loop = "neck"
to = "body"
[[garment.pin]]
vertices = [3, 1, 2]
to = "fixed"
[[garment.pin]]
loop = 2
[material]
total_mass = 1.5
stretch = [800, 700]
shear = 200
bending = 1e-6
damping = { stretch = 100, shear = 1, bending = 1e-5 }
[solver]
method = "bw1"
time_step = 0.005
steps_per_pose = 3
gravity = [0, 0, -9.81]
threads = 2
[collision]
offset = 0.004
voxel = 0.006
[adaption]
limit = 0.09
every = 4
cycles = 2
settle = 40
verify = false
[output]
every = 16
)");
  CHECK(scene.name == "t-shirt");
  CHECK(scene.body->steps == 50);
  CHECK(scene.body->match_triangles);
  CHECK(scene.garment.mesh == "shirt.obj");
  CHECK(scene.garment.grain == Vec3(0.0, -1.0, 0.0));
  REQUIRE(scene.garment.pins.size() == 3);
  CHECK(std::get<std::string>(scene.garment.pins[0].what) == "neck");
  CHECK(scene.garment.pins[0].to_body);
  CHECK(std::get<std::vector<int>>(scene.garment.pins[1].what) == std::vector<int>{3, 1, 2});
  CHECK_FALSE(scene.garment.pins[1].to_body);
  CHECK(std::get<std::string>(scene.garment.pins[2].what) == "2");
  CHECK(scene.garment.pins[2].to_body);
  CHECK(scene.material.total_mass == 1.5);
  CHECK(scene.material.stretch_warp == 800.0);
  CHECK(scene.material.stretch_weft == 700.0);
  CHECK(scene.material.shear == 200.0);
  CHECK(scene.material.bending == 1e-6);
  CHECK(scene.material.damping_stretch == 100.0);
  CHECK(scene.material.damping_shear == 1.0);
  CHECK(scene.material.damping_bending == 1e-5);
  CHECK(scene.solver.time_step == 0.005);
  CHECK(scene.solver.steps_per_pose == 3);
  CHECK(scene.solver.gravity == Vec3(0.0, 0.0, -9.81));
  CHECK(scene.solver.threads == 2);
  CHECK(scene.collision.offset == 0.004);
  CHECK(scene.collision.voxel == 0.006);
  REQUIRE(scene.adaption);
  CHECK(scene.adaption->limit == 0.09);
  CHECK(scene.adaption->every == 4);
  CHECK(scene.adaption->cycles == 2);
  CHECK(scene.adaption->settle == 40);
  CHECK_FALSE(scene.adaption->verify);
  REQUIRE(scene.output);
  CHECK(scene.output->every == 16);
  CHECK(timeStepsOfMotion(scene) == 2 * 50 * 3);
}

TEST_CASE("one number of stretch serves warp and weft") {
  const Scene scene = sceneOf(kBody + "[material]\nstretch = 500\n");
  CHECK(scene.material.stretch_warp == 500.0);
  CHECK(scene.material.stretch_weft == 500.0);
}

TEST_CASE("one pose is a body that stands still for its steps") {
  CHECK(timeStepsOfMotion(sceneOf("[body]\nposes = ['t.ply']\nsteps = 5\n[garment]\nmesh = 's.obj'\n")) == 20);
}

TEST_CASE("a scene without a body lasts as many steps as it says, and pins to where the cloth is") {
  const Scene scene = sceneOf(kNoBody + "[[garment.pin]]\nloop = 'top'\n");
  CHECK_FALSE(scene.body);
  CHECK(timeStepsOfMotion(scene) == 10);
  CHECK_FALSE(scene.garment.pins[0].to_body);
}

TEST_CASE("a misspelt key is named with its line and the nearest known one") {
  CHECK(errorOf(kBody + "[material]\nshear = 1\ndensty = 0.1\n") ==
        "scene.toml:6: [material] 'densty' is not a known key; did you mean 'density'?");
  CHECK(errorOf(kBody + "[adaptation]\nlimit = 0.1\n") ==
        "scene.toml:4: 'adaptation' is not a known table; did you mean 'adaption'?");
  CHECK(errorOf("nmae = 'x'\n" + kBody) == "scene.toml:1: 'nmae' is not a known key; did you mean 'name'?");
  CHECK(errorOf(kBody + "[output]\nfolder = 'x'\n") ==
        "scene.toml:5: [output] 'folder' is not a known key; known here: 'every'");
  CHECK(errorOf(kBody + "[[garment.pin]]\nlop = 'top'\n") ==
        "scene.toml:5: [[garment.pin]] 'lop' is not a known key; did you mean 'loop'?");
  CHECK(errorOf(kBody + "[material]\ndamping = {strech = 1}\n") ==
        "scene.toml:5: [material.damping] 'strech' is not a known key; did you mean 'stretch'?");
}

TEST_CASE("the first of several unknown keys in the file is named") {
  CHECK_THAT(errorOf(kBody + "[material]\nzz = 1\naa = 1\n"), StartsWith("scene.toml:5: [material] 'zz'"));
}

TEST_CASE("a misspelt key is named before what is missing for it") {
  CHECK_THAT(errorOf("[body]\npose = ['t.ply']\n"), EndsWith("did you mean 'poses'?"));
}

TEST_CASE("a value of another type is named with what was expected") {
  CHECK(errorOf(kBody + "[solver]\ntime_step = 'fast'\n") ==
        "scene.toml:5: [solver] time_step = 'fast': expected a number above 0 and at most 1 s, found a string");
  CHECK(errorOf(kBody + "[solver]\nsteps_per_pose = 4.0\n") ==
        "scene.toml:5: [solver] steps_per_pose = 4.0: expected a whole number from 1 to 10000, found a number with a "
        "fraction");
  CHECK(errorOf(kBody + "[adaption]\nverify = 1\n") ==
        "scene.toml:5: [adaption] verify = 1: expected true or false, found a whole number");
  CHECK(errorOf("name = 3\n" + kBody) == "scene.toml:1: name = 3: expected a string, found a whole number");
  CHECK(errorOf("body = 1\n") == "scene.toml:1: body = 1: expected a table [body], found a whole number");
  CHECK(errorOf("[body]\nposes = 't.ply'\n") ==
        "scene.toml:2: [body] poses = 't.ply': expected an array of strings; found a string");
  CHECK_THAT(errorOf("[body]\nposes = ['t.ply', 3]\n"), EndsWith("expected an array of strings; entry 2 is 3"));
  CHECK(errorOf(kBody + "[garment.pin]\nloop = 'top'\n") ==
        "scene.toml:4: [garment] pin: expected tables [[garment.pin]], in double brackets, found a table");
  CHECK_THAT(errorOf(kBody + "grain = 3\n"), EndsWith("found a whole number"));
  CHECK_THAT(errorOf(kBody + "grain = [0, 1]\n"), EndsWith("expected 3 numbers, x, y and z, found 2"));
  CHECK_THAT(errorOf(kBody + "grain = [0, 1, 'z']\n"), EndsWith("entry 3 is 'z'"));
}

TEST_CASE("an impossible value is named with what was expected") {
  const auto [line, label] = GENERATE(table<const char*, const char*>({
      {"[solver]\ntime_step = 0", "[solver] time_step = 0:"},
      {"[solver]\ntime_step = -0.1", "[solver] time_step = -0.1:"},
      {"[solver]\ntime_step = 1.5", "[solver] time_step = 1.5:"},
      {"[solver]\ntime_step = nan", "[solver] time_step = nan:"},
      {"[solver]\nsteps_per_pose = 0", "[solver] steps_per_pose = 0:"},
      {"[solver]\nmethod = 'euler'", "[solver] method = 'euler': expected 'auto', 'bw1', 'newton', 'pd' or 'pd-lbfgs'"},
      {"[solver]\nthreads = -1", "[solver] threads = -1:"},
      {"[solver]\nthreads = 99999999999", "[solver] threads = 99999999999:"},
      {"[solver]\ngravity = [0, inf, 0]", "[solver] gravity = [0, inf, 0]:"},
      {"[collision]\nvoxel = 0", "[collision] voxel = 0:"},
      {"[collision]\nvoxel = 3", "[collision] voxel = 3:"},
      {"[collision]\noffset = -0.001", "[collision] offset = -0.001:"},
      {"[collision]\noffset = 5", "[collision] offset = 5:"},
      {"[adaption]\nlimit = 0", "[adaption] limit = 0:"},
      {"[adaption]\nevery = 0", "[adaption] every = 0:"},
      {"[adaption]\ncycles = 0", "[adaption] cycles = 0:"},
      {"[adaption]\nsettle = -1", "[adaption] settle = -1:"},
      {"[output]\nevery = 0", "[output] every = 0:"},
      {"[material]\ndensity = 0", "[material] density = 0:"},
      {"[material]\ntotal_mass = -1.5", "[material] total_mass = -1.5:"},
      {"[material]\nstretch = -1", "[material] stretch = -1:"},
      {"[material]\nstretch = [800, -1]", "[material] stretch = [800, -1]:"},
      {"[material]\nstretch = [800]", "[material] stretch = [800]: expected one number or two"},
      {"[material]\nshear = inf", "[material] shear = inf:"},
      {"[material]\nbending = -1e-6", "[material] bending = -1e-06:"},
      {"[material]\ndamping = {shear = -1}", "[material.damping] shear = -1:"},
      {"grain = [0, 0, 0]", "[garment] grain = [0, 0, 0]: expected a direction, not zero"},
  }));
  const std::string error = errorOf(kBody + line + "\n");
  INFO(line);
  CHECK_THAT(error, StartsWith("scene.toml:") && Contains(label) && Contains(": expected "));
}

TEST_CASE("cloth without any stiffness is refused") {
  CHECK_THAT(errorOf(kBody + "[material]\nstretch = 0\nshear = 0\n"), Contains("there is no cloth"));
}

TEST_CASE("keys that exclude each other are refused together") {
  CHECK_THAT(errorOf(kBody + "[material]\ndensity = 0.1\ntotal_mass = 1.5\n"),
             EndsWith("expected either density or total_mass, not both"));
  CHECK_THAT(errorOf(kBody + "builtin = 't-shirt'\n"), EndsWith("expected either mesh or builtin, not both"));
  CHECK_THAT(errorOf(kBody + "vertices = 3000\n"), Contains("vertices = 3000: expected builtin"));
  CHECK_THAT(errorOf(kBody + "[[garment.pin]]\nloop = 'top'\nvertices = [1]\n"),
             EndsWith("expected either loop or vertices, not both"));
  CHECK_THAT(errorOf(kBody + "[solver]\nsteps = 10\n"), Contains("[solver] steps = 10: expected steps_per_pose"));
}

TEST_CASE("what a scene needs and lacks is named") {
  CHECK(errorOf("[body]\nsteps = 3\n") == "scene.toml:1: [body] poses is missing: expected mesh files, one a pose");
  CHECK_THAT(errorOf("[body]\nposes = []\n"), EndsWith("expected an array of strings; found none"));
  CHECK_THAT(errorOf("[body]\nposes = ['']\n"), EndsWith("entry 1 is ''"));
  CHECK_THAT(errorOf("[body]\nposes = ['t.ply']\n"), Contains("garment is missing: expected a table [garment]"));
  CHECK_THAT(errorOf("[body]\nposes = ['t.ply']\n[garment]\n"), Contains("[garment] mesh is missing"));
  CHECK_THAT(errorOf(kBody + "[[garment.pin]]\nto = 'body'\n"), Contains("[[garment.pin]] loop is missing"));
  CHECK_THAT(errorOf(kBody + "[[garment.pin]]\nvertices = []\n"), EndsWith("found none"));
  CHECK_THAT(errorOf(kBody + "[[garment.pin]]\nvertices = [-1]\n"), EndsWith("entry 1 is -1"));
}

TEST_CASE("what only a body gives sense to is refused without one") {
  CHECK_THAT(errorOf("[garment]\nmesh = 's.obj'\n"),
             Contains("solver is missing: expected a table [solver] with steps"));
  CHECK_THAT(errorOf("[garment]\nmesh = 's.obj'\n[solver]\n"), Contains("[solver] steps is missing"));
  CHECK_THAT(errorOf("[garment]\nmesh = 's.obj'\n[solver]\nsteps = 0\n"), Contains("[solver] steps = 0: expected"));
  CHECK_THAT(errorOf("[garment]\nmesh = 's.obj'\n[solver]\nsteps_per_pose = 4\n"), Contains("expected steps, since"));
  CHECK_THAT(errorOf(kNoBody + "[[garment.pin]]\nloop = 'top'\nto = 'body'\n"),
             Contains("to = 'body': expected 'fixed', since the scene has no [body]"));
  CHECK_THAT(errorOf(kNoBody + "[collision]\noffset = 0.01\n"), Contains("collision: expected a [body]"));
  CHECK_THAT(errorOf("solver = {steps = 10}\n[garment]\nbuiltin = 'dress'\n"),
             Contains("[garment] builtin = 'dress': expected [body] builtin = 'mannequin'"));
}

TEST_CASE("built-in garments start on the pose that they are made on") {
  CHECK_THAT(errorOf("[body]\nbuiltin = 'mannequin'\nposes = ['a']\n[garment]\nbuiltin = 'dress'\n"),
             Contains("expected [body] poses to begin with 't'"));
}

TEST_CASE("a pose that the mannequin does not have is refused") {
  CHECK_THAT(errorOf("[body]\nbuiltin = 'mannequin'\nposes = ['t', 'sitting']\n"),
             StartsWith("scene.toml:3: [body] poses") && EndsWith("it has no 'sitting'"));
}

TEST_CASE("a motion of absurd length is refused") {
  CHECK_THAT(
      errorOf("[body]\nposes = ['t.ply']\nsteps = 100000\n[garment]\nmesh = 's.obj'\n[solver]\n"
              "steps_per_pose = 10000\n"),
      StartsWith("scene.toml:3: [body] steps = 100000: expected at most 10000000 time steps in all, found 1000000000"));
  CHECK_THAT(errorOf("[solver]\nsteps = 10000000\n[garment]\nmesh = 's.obj'\n[adaption]\ncycles = 1000\n"),
             Contains("[solver] steps = 10000000: expected at most"));
}

TEST_CASE("a name that is no folder's is refused") {
  CHECK_THAT(errorOf("name = '../x'\n" + kBody), Contains("expected a name that can be a folder's"));
  CHECK_THAT(errorOf("name = ''\n" + kBody), Contains("expected a string that is not empty"));
}

TEST_CASE("a file that is missing or is not TOML is refused in one line") {
  const TemporaryDirectory directory;
  CHECK_THAT(messageOf<InputError>([&] { readScene(directory.path / "none.toml"); }),
             EndsWith("none.toml: no such scene file"));
  CHECK_THAT(messageOf<InputError>([&] { readScene(directory.path); }), EndsWith("cannot be read as a scene file"));
  CHECK_THAT(errorOf("name = 'a'\nname = 'b'\n"), StartsWith("scene.toml:2: not TOML: "));
  CHECK_THAT(errorOf("\n\n[body\n"), StartsWith("scene.toml:3: not TOML: "));
}

TEST_CASE("the scenes that come with the project can be read") {
  int count = 0;
  for (const char* folder : {"scenes", "tests/apps/scans"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(EASE_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".toml") continue;
      INFO(entry.path());
      const Scene scene = readScene(entry.path());
      CHECK(scene.name == entry.path().stem());
      CHECK(scene.adaption);
      ++count;
    }
  }
  CHECK(count >= 6);
}
