#include "apps/toml_table.h"

#include "tests/apps/scene_text.h"

using namespace ease;
using Catch::Contains;
using Catch::EndsWith;
using Catch::StartsWith;

TEST_CASE("a misspelt key is named with its line and the nearest known one") {
  CHECK(errorOf(kBody + "[material]\nshear = 1\ndensty = 0.1\n") ==
        "scene.toml:6: [material] 'densty' is not a known key; did you mean 'density'?");
  CHECK(errorOf(kBody + "[adaptation]\nlimit = 0.1\n") ==
        "scene.toml:4: 'adaptation' is not a known table; did you mean 'adaption'?");
  CHECK(errorOf("nmae = 'x'\n" + kBody) == "scene.toml:1: 'nmae' is not a known key; did you mean 'name'?");
  CHECK(errorOf(kBody + "[output]\nfolder = 'x'\n") ==
        "scene.toml:5: [output] 'folder' is not a known key; known here: 'every' or 'replays'");
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
  CHECK(errorOf("[body]\nposes = 7\n") ==
        "scene.toml:2: [body] poses = 7: expected an array of strings; found a whole number");
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
      {"[collision]\nfriction = -0.1", "[collision] friction = -0.1:"},
      {"[collision]\nfriction = 6", "[collision] friction = 6:"},
      {"[collision]\nfriction = 'much'", "[collision] friction"},
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

TEST_CASE("a file that is missing or is not TOML is refused in one line") {
  const TemporaryDirectory directory;
  CHECK_THAT(messageOf<InputError>([&] { readScene(directory.path / "none.toml"); }),
             EndsWith("none.toml: no such scene file"));
  CHECK_THAT(messageOf<InputError>([&] { readScene(directory.path); }), EndsWith("cannot be read as a scene file"));
  CHECK(errorOf("") == "scene.toml: is empty: expected a scene, with a table [garment]");
  CHECK_THAT(errorOf("# nothing yet\n"), Contains("garment is missing: expected a table [garment]"));
  CHECK_THAT(errorOf("name = 'a'\nname = 'b'\n"), StartsWith("scene.toml:2: not TOML: "));
  CHECK_THAT(errorOf("\n\n[body\n"), StartsWith("scene.toml:3: not TOML: "));
  CHECK_THAT(errorOf("[adaption]\nverify = fals\n"), StartsWith("scene.toml:2: not TOML: "));
}
