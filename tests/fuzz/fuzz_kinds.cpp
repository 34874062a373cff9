// What is damaged: scenes with every table, every mesh format, a checkpoint.
#include "tests/collision/bodies.h"
#include "tests/fuzz/command_fuzz.h"
#include "tests/fuzz/mesh_formats.h"
#include "tests/sheet.h"

namespace ease {

namespace {

const std::string kPoses = "\"low.obj\", \"high.obj\"";

// A sheet pressed by a ball that rises.
std::string scene(const std::string& garment, const std::string& poses) {
  return "name = \"pressed\"\n[body]\nposes = [" + poses + "]\nsteps = 2\n[garment]\nmesh = \"" + garment +
         "\"\ngrain = [0, -1, 0]\n[[garment.pin]]\nvertices = [0, 5]\nto = \"fixed\"\n[[garment.pin]]\nat = [0.1, 0.1, "
         "0.12]\nradius = 0.03\n[[garment.paint]]\nat = [0.1, 0.1, 0.1]\nradius = 0.1\nscale = 1.2\n"
         "[garment.comfort]\noffset = 0.006\n[[garment.comfort.region]]\nat = [0, 0.1, 0.1]\nradius = 0.1\noffset = "
         "0.01\n"
         "[material]\ntotal_mass = 0.05\nstretch = [800, 700]\nshear = 200\nshear_form = \"orthogonal\"\n"
         "bending = 1e-6\ndamping = { stretch = 1, shear = 1, bending = 1e-6 }\n"
         "[solver]\nmethod = \"auto\"\ntolerance = 0.05\ntime_step = 0.0025\nsteps_per_pose = 2\n"
         "gravity = [0, -9.81, 0]\nthreads = 1\n[collision]\nvoxel = 0.01\nstiffness = 3e6\nfriction = 0.3\n"
         "[adaption]\nmode = 'sequential'\nlimit = 0.1\nevery = 2\ncycles = 2\nsettle = 2\nverify = "
         "true\n[output]\nevery = 2\n";
}

std::string hangingScene() {
  return "[garment]\nmesh = \"garment.obj\"\n[[garment.pin]]\nloop = \"top\"\n"
         "[material]\ndensity = 0.15\nmembrane = \"isotropic\"\nmu = 300\nlambda = 100\nbending = 1e-6\n"
         "[solver]\nmethod = \"newton\"\nresidual = 0.01\nsteps = 6\ntime_step = 0.01\n[output]\nevery = 3\n";
}

// A tube around a capsule, with every tool.
const std::string kToolScene = R"(name = "tube"
[body]
poses = ["capsule.obj"]
steps = 2
[garment]
resolution = 150
smoothing = 0.01
[[garment.boundary]]
name = "top"
plane = { point = [0, 0.15, 0], normal = [0, 1, 0], near = [0, 0.15, 0.1] }
[[garment.boundary]]
name = "hem"
points = [[0, -0.1, 0.15], [0.15, -0.1, 0], [0, -0.1, -0.15], [-0.15, -0.1, 0]]
[garment.region]
seed = [0, 0, 0.15]
[[garment.extension]]
loop = "hem"
length = 0.05
scale = 1.2
[garment.comfort]
offset = 0.005
[[garment.comfort.region]]
at = [0, 0.02, 0.1]
radius = 0.2
offset = 0.015
[[garment.paint]]
at = [0.17, 0.04, 0]
radius = 0.12
scale = 1.1
[[garment.pin]]
loop = "top"
[[garment.seam]]
name = "left"
from = "hem"
to = "top"
points = [[0.15, 0, 0]]
[[garment.seam]]
name = "waist"
plane = { point = [0, 0.05, 0], normal = [0, 1, 0], near = [0, 0.05, 0.1] }
[solver]
method = "bw1"
steps_per_pose = 2
[adaption]
mode = 'sequential'
verify = false
)";

}  // namespace

std::vector<FuzzKind> fuzzKinds() {
  const TriangleMesh ball = bodies::sphere(0.1, 3), high = bodies::moved(ball, Vec3(0.0, 0.01, 0.0));
  TriangleMesh sheet = makeSheet(4, 4, 0.1, 0.1);
  sheet.positions.col(2).array() += 0.12;
  const std::string capsule = bytesOf(bodies::capsule(0.2, 0.15, 3), "mesh.obj");
  const std::string ball_obj = bytesOf(ball, "mesh.obj"), high_obj = bytesOf(high, "mesh.obj");
  const std::string sheet_obj = bytesOf(sheet, "mesh.obj");
  const std::vector<std::string> run = {"run", "scene.toml", "-o", "out", "--threads", "1"};

  std::vector<FuzzKind> kinds = {
      {"run, scene",
       run,
       {{"scene.toml", scene("garment.obj", kPoses)},
        {"garment.obj", sheet_obj},
        {"low.obj", ball_obj},
        {"high.obj", high_obj}},
       "scene.toml"},
      {"run, scene without a body", run, {{"scene.toml", hangingScene()}, {"garment.obj", sheet_obj}}, "scene.toml"},
      {"run, scene with tools", run, {{"scene.toml", kToolScene}, {"capsule.obj", capsule}}, "scene.toml"},
      {"garment, scene with tools",
       {"garment", "scene.toml", "-o", "out", "--pieces"},
       {{"scene.toml", kToolScene}, {"capsule.obj", capsule}},
       "scene.toml"}};
  for (const std::string& file : kMeshFiles) {
    kinds.push_back({"run, garment " + file,
                     run,
                     {{"scene.toml", scene(file, kPoses)},
                      {file, bytesOf(sheet, file)},
                      {"low.obj", ball_obj},
                      {"high.obj", high_obj}},
                     file});
    kinds.push_back({"run, body " + file,
                     run,
                     {{"scene.toml", scene("garment.obj", "\"" + file + "\"")},
                      {"garment.obj", sheet_obj},
                      {file, bytesOf(ball, file)}},
                     file});
  }
  return kinds;
}

}  // namespace ease
