#include "apps/scene.h"

#include "apps/scene_run.h"
#include "tests/apps/scene_text.h"
#include "tests/places.h"

using namespace ease;
using Catch::Contains;
using Catch::EndsWith;
using Catch::StartsWith;

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
  CHECK(scene.solver.method == Method::automatic);
  CHECK(scene.solver.time_step == 0.0025);
  CHECK(scene.solver.steps_per_pose == 4);
  CHECK(scene.collision.offset == 0.005);
  CHECK(scene.collision.friction == 0.0);
  CHECK_FALSE(scene.adaption);
  CHECK_FALSE(scene.output);
  CHECK(timeStepsOfMotion(replaySchedule(scene)) == 240);
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
friction = 0.4
[adaption]
mode = 'sequential'
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
  CHECK(scene.collision.friction == 0.4);
  REQUIRE(scene.adaption);
  CHECK(scene.adaption->limit == 0.09);
  CHECK(scene.adaption->every == 4);
  CHECK(scene.adaption->cycles == 2);
  CHECK(scene.adaption->settle == 40);
  CHECK_FALSE(scene.adaption->verify);
  REQUIRE(scene.output);
  CHECK(scene.output->every == 16);
  CHECK_FALSE(scene.output->replays);
  CHECK(timeStepsOfMotion(replaySchedule(scene)) == 2 * 50 * 3);
}

TEST_CASE("replays are written where there are any") {
  CHECK(sceneOf(kBody + "[adaption]\n[output]\nreplays = true\n").output->replays);
  CHECK_THAT(errorOf(kBody + "[output]\nreplays = true\n"),
             Contains("replays") && Contains("nothing else is replayed"));
  CHECK_THAT(errorOf(kBody + "[adaption]\nmode = 'sequential'\nverify = false\n[output]\nreplays = true\n"),
             Contains("nothing else is replayed"));
}

TEST_CASE("one number of stretch serves warp and weft") {
  const Scene scene = sceneOf(kBody + "[material]\nstretch = 500\n");
  CHECK(scene.material.stretch_warp == 500.0);
  CHECK(scene.material.stretch_weft == 500.0);
}

TEST_CASE("one pose is a body that stands still for its steps") {
  CHECK(timeStepsOfMotion(
            replaySchedule(sceneOf("[body]\nposes = ['t.ply']\nsteps = 5\n[garment]\nmesh = 's.obj'\n"))) == 20);
}

TEST_CASE("a scene without a body lasts as many steps as it says, and pins to where the cloth is") {
  const Scene scene = sceneOf(kNoBody + "[[garment.pin]]\nloop = 'top'\n");
  CHECK_FALSE(scene.body);
  CHECK(timeStepsOfMotion(replaySchedule(scene)) == 10);
  CHECK_FALSE(scene.garment.pins[0].to_body);
}

TEST_CASE("cloth without any stiffness is refused") {
  CHECK_THAT(errorOf(kBody + "[material]\nstretch = 0\nshear = 0\n"), Contains("there is no cloth"));
}

TEST_CASE("keys that exclude each other are refused together") {
  CHECK_THAT(errorOf(kBody + "[material]\ndensity = 0.1\ntotal_mass = 1.5\n"),
             EndsWith("expected either density or total_mass, not both"));
  CHECK_THAT(errorOf(kBody + "builtin = 't-shirt'\n"), EndsWith("expected either mesh or builtin, not both"));
  CHECK_THAT(errorOf(kBody + "vertices = 3000\n"), Contains("it sets the size of a builtin garment"));
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

TEST_CASE("the mannequin takes measures within its range, and pose files take none") {
  const std::string end = "}\n[garment]\nbuiltin = 't-shirt'\n",
                    begin = "body = {builtin = 'mannequin', poses = ['t'], ";
  const Scene scene = sceneOf(begin + "height = 1.8, chest = 1.0, hips = 1.1" + end);
  CHECK(scene.body->measures.height == 1.8);
  CHECK(scene.body->measures.chest == 1.0);
  CHECK_FALSE(scene.body->measures.waist.has_value());
  CHECK_THAT(errorOf(begin + "chest = 98" + end), Contains("[body] chest = 98") && Contains("0.652"));
  CHECK_THAT(errorOf(begin + "height = 0.3" + end), Contains("[body] height = 0.3"));
  CHECK_THAT(errorOf("body = {poses = ['t.ply', 'a.ply'], waist = 0.7}\n[garment]\nmesh = 's.obj'\n"),
             Contains("waist") && Contains("builtin = 'mannequin'"));
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

TEST_CASE("the scenes that come with the project can be read") {
  int count = 0;
  for (const char* folder : {"scenes", "tests/apps/scans"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(kSourceDirectory) / folder)) {
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

TEST_CASE("the program divides the motion into time steps unless the scene does") {
  const std::string rest = "[garment]\nmesh = 's.obj'\n", body = "[body]\nposes = ['t.ply', 'a.ply']\n";
  const auto check = [](const Scene& scene, double time_step, int steps_per_pose, int steps, int every) {
    CHECK(scene.solver.time_step == Approx(time_step));
    CHECK(scene.solver.steps_per_pose == steps_per_pose);
    CHECK(scene.body->steps == steps);
    if (scene.adaption) CHECK(scene.adaption->every == every);
  };
  check(sceneOf(body + rest), 0.0025, 4, 60, 0);
  check(sceneOf(body + rest + "[adaption]\n"), 0.0125, 1, 48, 2);
  check(sceneOf(body + "seconds_per_pose = 1.0\n" + rest + "[adaption]\n"), 0.0125, 1, 80, 2);
  check(sceneOf(body + rest + "[adaption]\nmode = 'sequential'\n"), 0.0025, 4, 60, 8);
  check(sceneOf(body + rest + "[solver]\ntime_step = 0.005\n[adaption]\n"), 0.005, 1, 120, 4);
  check(sceneOf(body + "steps = 7\n" + rest + "[adaption]\n"), 0.0125, 1, 7, 2);
  CHECK(sceneOf(body + rest + "[adaption]\n").solver.tolerance == Approx(0.2));
  CHECK(sceneOf(body + rest + "[adaption]\n[solver]\ntolerance = 0.01\n").solver.tolerance == Approx(0.01));
  CHECK_THAT(errorOf(body + "steps = 7\nseconds_per_pose = 1.0\n" + rest),
             EndsWith("expected either seconds_per_pose or steps, not both"));
  CHECK_THAT(errorOf(body + rest + "[adaption]\nmode = 'sequential'\ntarget = 0.01\n"),
             EndsWith("it belongs to mode = 'passes'"));
  CHECK_THAT(errorOf(body + rest + "[adaption]\nverify = false\n"), EndsWith("false needs mode = 'sequential'"));
}
