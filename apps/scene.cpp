#include "apps/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/mesh_list.h"
#include "apps/run_inputs.h"
#include "apps/scene_material.h"
#include "apps/scene_tools.h"
#include "apps/toml_table.h"
#include "apps/words.h"
#include "collision/body/mannequin.h"
#include "garment/builtin_garment.h"

namespace ease {

namespace {

// A longer motion is assumed to be a typing error: at 100 steps per second it would take more than a day.
constexpr double kMaxTimeSteps = 1e7;

constexpr double kMeasuringInterval = 0.02;  // s, between measurements of the stretch by default

// A rest shape that is fitted in passes depends little on how accurate the time steps are (docs/benchmarks.md): by
// default they are as long, and as rough, as pays.
constexpr double kPassTimeStep = 0.0125;  // s
constexpr double kPassTolerance = 0.2;
constexpr double kPassCompression = 0.05;     // wrinkles finer than the triangles (docs/numerics.md)
constexpr double kPassBendingDamping = 1e-5;  // N m s: undamped folds take twice the iterations for the same fit

/// Measures of the built-in body: the height first, since the others are judged by it.
BodyMeasures readMeasures(const TomlTable& table) {
  BodyMeasures measures;
  const auto read = [&](const char* key, std::optional<double>& measure) {
    if (!table.has(key)) return;
    const MeasureRange range = BodySize::range(measures, key);
    measure = table.number(key, 0.0, {range.low, range.high, false, "m"});
  };
  read("height", measures.height);
  read("chest", measures.chest);
  read("waist", measures.waist);
  read("hips", measures.hips);
  return measures;
}

BodyScene readBody(const TomlTable& table, const std::filesystem::path& folder) {
  table.allow({"poses", "builtin", "seconds_per_pose", "steps", "match", "unit", "up", "facing", "weld", "holes",
               "align", "height", "chest", "waist", "hips"});
  if (table.has("steps") && table.has("seconds_per_pose"))
    table.refuse("steps", "either seconds_per_pose or steps, not both");
  BodyScene body;
  body.builtin = table.choice("builtin", body.builtin, {"mannequin"});
  body.poses = table.isText("poses") ? std::vector{table.text("poses", "")} : table.texts("poses");
  if (body.poses.empty())
    table.refuse("poses", body.builtin.empty() ? "mesh files, one a pose" : listWords(mannequinPoses()));
  body.seconds_per_pose = table.number("seconds_per_pose", body.seconds_per_pose, {0.0, 1e4, true, "s"});
  body.steps = table.integer("steps", body.steps, 1, 100000);
  body.match_triangles = table.choice("match", "index", {"index", "triangles"}) == "triangles";

  if (body.builtin.empty()) {
    std::string missing;
    const std::vector<std::string> files = expandFiles(body.poses, folder, missing);
    if (files.empty()) table.refuse("poses", fmt::format("mesh files; none is called '{}'", missing));
    body.poses = files;
    body.frame = readFrame(table);
    body.weld = table.boolean("weld", body.weld);
    body.close_all = table.choice("holes", "far", {"far", "close"}) == "close";
    if (table.has("align")) body.align = table.boolean("align", true);
    for (const char* key : {"height", "chest", "waist", "hips"})
      if (table.has(key)) table.refuse(key, "no such key with pose files: it is a measure of builtin = 'mannequin'");
    return body;
  }
  for (const char* key : {"unit", "up", "facing", "weld", "holes", "align", "match"})
    if (table.has(key)) table.refuse(key, "no such key with builtin = 'mannequin': it describes pose files");
  body.measures = readMeasures(table);
  for (const std::string& pose : body.poses) {
    const std::vector<std::string>& known = mannequinPoses();
    if (std::find(known.begin(), known.end(), pose) == known.end())
      table.refuse("poses", fmt::format("poses of the mannequin, {}; it has no '{}'", listWords(known), pose));
  }
  return body;
}

PinScene readPin(const TomlTable& table, bool has_body) {
  table.allow({"loop", "vertices", "at", "radius", "to"});
  for (const char* key : {"vertices", "at"})
    if (table.has("loop") && table.has(key)) table.refuse(key, fmt::format("either loop or {}, not both", key));
  if (table.has("vertices") && table.has("at")) table.refuse("at", "either vertices or at, not both");
  PinScene pin;
  if (table.has("at")) {
    pin.what = readBall(table);
  } else if (table.has("vertices")) {
    pin.what = table.integers("vertices", 0, 1000000000);
  } else if (table.isText("loop")) {
    pin.what = table.text("loop", "");
  } else if (table.has("loop")) {
    pin.what = std::to_string(table.integer("loop", 0, 0, 1000000));
  } else {
    table.refuse("loop", "a loop, e.g. loop = 'top', or vertices, or at and radius");
  }
  pin.to_body = table.choice("to", has_body ? "body" : "fixed", {"body", "fixed"}) == "body";
  if (pin.to_body && !has_body) table.refuse("to", "'fixed', since the scene has no [body]");
  return pin;
}

GarmentScene readGarment(const TomlTable& table, const std::optional<BodyScene>& body, bool may_be_draft) {
  table.allow({"mesh", "builtin", "vertices", "grain", "pin", "resolution", "edge_length", "smoothing", "boundary",
               "region", "extension", "paint", "comfort", "seam", "unit", "up", "facing", "weld"});
  GarmentScene garment;
  garment.mesh = table.text("mesh", garment.mesh);
  garment.builtin = table.choice("builtin", garment.builtin, {"t-shirt", "dress"});
  const bool built_in = !garment.builtin.empty();
  if (built_in && !garment.mesh.empty()) table.refuse("builtin", "either mesh or builtin, not both");
  readGarmentTools(table, body.has_value(), may_be_draft, garment);
  if (!built_in && garment.mesh.empty() && !garment.tools) garment.is_draft = true;
  if (garment.is_draft && !may_be_draft)
    table.refuse("mesh", "a mesh file, or builtin = 't-shirt' on the mannequin, or [[garment.boundary]] loops");
  if (built_in && !(body && body->builtin == "mannequin"))
    table.refuse("builtin", "[body] builtin = 'mannequin', since built-in garments are made on it");
  if (built_in && body->poses.front() != "t")
    table.refuse("builtin", "[body] poses to begin with 't', since built-in garments are made on that pose");
  if (garment.tools && table.has("vertices")) table.refuse("vertices", "resolution, since the garment has boundaries");
  if (!built_in && !garment.is_draft && table.has("vertices"))
    table.refuse("vertices", "no such key with a mesh file: it sets the size of a builtin garment");
  for (const char* key : {"unit", "up", "facing", "weld"})
    if (garment.mesh.empty() && table.has(key))
      table.refuse(key, "no such key without a mesh file, which it describes");
  if (!garment.mesh.empty()) garment.frame = readFrame(table, body ? body->frame : MeshFrame());
  garment.weld = table.boolean("weld", garment.weld);
  garment.vertices = table.integer("vertices", garment.vertices, kMinBuiltinVertices, kMaxBuiltinVertices);

  garment.grain = readVec3(table, "grain", garment.grain, 1e6, "");
  if (garment.grain.norm() < 1e-6) table.refuse("grain", "a direction, not zero");
  garment.grain.normalize();
  for (const TomlTable& pin : table.tables("pin")) garment.pins.push_back(readPin(pin, body.has_value()));
  return garment;
}

SolverScene readSolver(const TomlTable& table, bool has_body) {
  table.allow(
      {"method", "tolerance", "residual", "iterations", "time_step", "steps_per_pose", "steps", "gravity", "threads"});
  SolverScene solver;
  const std::string method = table.choice("method", nameOf(solver.method), {"auto", "bw1", "newton", "pd", "pd-lbfgs"});
  solver.method = methodNamed(method);
  const auto onlyFor = [&](const char* key, std::initializer_list<const char*> methods, const char* expected) {
    if (table.has(key) && std::find(methods.begin(), methods.end(), method) == methods.end())
      table.refuse(key, expected);
  };
  onlyFor("tolerance", {"auto", "pd-lbfgs"}, "method = 'auto' or 'pd-lbfgs' for a tolerance");
  onlyFor("residual", {"newton"}, "method = 'newton' for a residual");
  onlyFor("iterations", {"pd"}, "method = 'pd' for a number of iterations");
  solver.tolerance = table.number("tolerance", solver.tolerance, {0.0, 1.0, true, ""});
  solver.residual = table.number("residual", solver.residual, {0.0, 1e6, true, "m/s^2"});
  solver.iterations = table.integer("iterations", solver.iterations, 1, 100000);
  solver.time_step = table.number("time_step", solver.time_step, {0.0, 1.0, true, "s"});
  if (has_body && table.has("steps"))
    table.refuse("steps", "steps_per_pose, since with a [body] the poses say how long the motion lasts");
  if (!has_body && table.has("steps_per_pose")) table.refuse("steps_per_pose", "steps, since the scene has no [body]");
  if (!has_body && !table.has("steps")) table.refuse("steps", "how many time steps a scene without a [body] lasts");
  solver.steps_per_pose = table.integer("steps_per_pose", solver.steps_per_pose, 1, 10000);
  solver.steps = table.integer("steps", solver.steps, 1, static_cast<int>(kMaxTimeSteps));
  solver.gravity = readVec3(table, "gravity", solver.gravity, 1000.0, "m/s^2");
  solver.threads = table.integer("threads", solver.threads, 0, 1024);
  return solver;
}

CollisionScene readCollision(const TomlTable& table, const GarmentScene& garment) {
  table.allow({"offset", "voxel", "stiffness", "friction"});
  if (garment.comfort_offset && table.has("offset"))
    table.refuse("offset", "either this or [garment.comfort] offset, not both");
  CollisionScene collision;
  collision.offset = table.number("offset", collision.offset, {0.0, 0.1, false, "m"});
  collision.voxel = table.number("voxel", collision.voxel, {0.0005, 0.1, false, "m"});
  collision.stiffness = table.number("stiffness", collision.stiffness, {0.0, 1e10, true, "N/m^3"});
  collision.friction = table.number("friction", collision.friction, {0.0, 5.0, false, ""});
  return collision;
}

AdaptionScene readAdaption(const TomlTable& table, double time_step) {
  table.allow({"mode", "limit", "target", "passes", "every", "cycles", "settle", "verify"});
  AdaptionScene adaption;
  const bool sequential = table.choice("mode", "passes", {"passes", "sequential"}) == "sequential";
  adaption.mode = sequential ? AdaptionMode::sequential : AdaptionMode::passes;
  for (const char* key : {"target", "passes"})
    if (sequential && table.has(key))
      table.refuse(key, "no such key with mode = 'sequential': it belongs to mode = 'passes'");
  adaption.fit.target = table.number("target", adaption.fit.target, {0.0, 1.0, false, ""});
  adaption.fit.max_passes = table.integer("passes", adaption.fit.max_passes, 1, 1000);
  adaption.limit = table.number("limit", adaption.limit, {0.0, 2.0, true, ""});
  adaption.every = std::max(1, static_cast<int>(std::lround(kMeasuringInterval / time_step)));
  adaption.every = table.integer("every", adaption.every, 1, 1000000);
  adaption.cycles = table.integer("cycles", adaption.cycles, 1, 1000);
  adaption.settle = table.integer("settle", adaption.settle, 0, 1000000);
  adaption.verify = table.boolean("verify", adaption.verify);
  if (!sequential && !adaption.verify)
    table.refuse("verify", "true, since passes always verify; false needs mode = 'sequential'");
  return adaption;
}

OutputScene readOutput(const TomlTable& table, const std::optional<AdaptionScene>& adaption) {
  table.allow({"every", "replays"});
  OutputScene output;
  output.every = table.integer("every", output.every, 1, 1000000);
  output.replays = table.boolean("replays", output.replays);
  if (output.replays && !(adaption && adaption->verify))
    table.refuse("replays", "an [adaption] that is verified, or false: nothing else is replayed");
  return output;
}

/// Divides the motion from a pose to the next into time steps, and chooses the tolerance, as far as the scene does not.
void divideMotion(const TomlTable& root, Scene& scene) {
  const auto body = root.table("body"), solver = root.table("solver"), adaption = root.table("adaption");
  const auto gives = [&](const char* key) { return solver && solver->has(key); };
  const bool in_passes = body && adaption && adaption->choice("mode", "passes", {"passes", "sequential"}) == "passes";
  if (in_passes && !gives("tolerance")) scene.solver.tolerance = kPassTolerance;
  if (in_passes && !gives("time_step")) scene.solver.time_step = kPassTimeStep;
  if (in_passes && !gives("steps_per_pose")) scene.solver.steps_per_pose = 1;
  if (!body || body->has("steps")) return;
  const double step_s = scene.solver.time_step * scene.solver.steps_per_pose;
  const double steps = std::max(1.0, std::round(scene.body->seconds_per_pose / step_s));
  if (steps > kMaxTimeSteps)
    body->refuse("seconds_per_pose", fmt::format("at most {:.0f} time steps, found {:.0f}", kMaxTimeSteps, steps));
  scene.body->steps = static_cast<int>(steps);
}

/// Reads the scene's name.  It is also the name of the result folder, so it must be a single folder that is not hidden.
std::string readName(const TomlTable& root, const std::filesystem::path& file, bool names_folder) {
  const std::string name = root.text("name", file.stem().string());
  if (names_folder && (name.front() == '.' || name.find_first_of("/\\") != std::string::npos))
    root.refuse("name", "a name that can be a folder's: no slash, no dot in front; or -o with the folder");
  return name;
}

/// Throws InputError for a motion of absurd length, whose number of time steps could overflow.
void checkLength(const TomlTable& root, const Scene& scene) {
  double steps = scene.solver.steps;
  if (scene.body) {
    const double intervals = std::max<size_t>(scene.body->poses.size() - 1, 1);
    steps = intervals * scene.body->steps * scene.solver.steps_per_pose;
  }
  if (scene.adaption) steps = steps * scene.adaption->cycles + scene.adaption->settle;
  if (steps <= kMaxTimeSteps) return;
  root.table(scene.body ? "body" : "solver")
      ->refuse("steps", fmt::format("at most {:.0f} time steps in all, found {:.0f}", kMaxTimeSteps, steps));
}

Scene readRoot(const TomlTable& root, const std::filesystem::path& file, bool may_be_draft, bool names_folder) {
  root.allow({"name", "body", "garment", "material", "solver", "collision", "adaption", "output", "pattern"});
  Scene scene;
  scene.file = file;
  scene.name = readName(root, file, names_folder);
  if (const auto body = root.table("body")) scene.body = readBody(*body, file.parent_path());
  const auto garment = root.table("garment");
  if (!garment && !may_be_draft) root.refuse("garment", "a table [garment] with a mesh or a builtin garment");
  if (garment)
    scene.garment = readGarment(*garment, scene.body, may_be_draft);
  else
    scene.garment.is_draft = true;
  const auto material = root.table("material");
  if (material) scene.material = readMaterial(*material);
  if (const auto solver = root.table("solver"))
    scene.solver = readSolver(*solver, scene.body.has_value());
  else if (!scene.body)
    root.refuse("solver", "a table [solver] with steps, since the scene has no [body]");
  if (const auto collision = root.table("collision")) {
    if (!scene.body) root.refuse("collision", "a [body] to collide with, or no such table");
    scene.collision = readCollision(*collision, scene.garment);
  }
  if (scene.garment.comfort_offset) scene.collision.offset = *scene.garment.comfort_offset;
  divideMotion(root, scene);
  if (const auto adaption = root.table("adaption")) scene.adaption = readAdaption(*adaption, scene.solver.time_step);
  if (fitsInPasses(scene)) {
    if (!material || !material->has("compression")) scene.material.compression = kPassCompression;
    if (!material || !material->has("damping")) scene.material.damping_bending = kPassBendingDamping;
  }
  if (const auto output = root.table("output")) scene.output = readOutput(*output, scene.adaption);
  if (const auto pattern = root.table("pattern")) scene.pattern = readPattern(*pattern);
  checkLength(root, scene);
  scene.tables_of_run = tablesOfRun(root, scene.body && scene.body->builtin.empty());
  return scene;
}

}  // namespace

Scene readScene(const std::filesystem::path& file, bool names_folder) {
  return readRoot(TomlTable::read(file), file, false, names_folder);
}

Scene readDraft(const std::string& text, const std::filesystem::path& file) {
  return readRoot(TomlTable::parse(text, file), file, true, true);
}

}  // namespace ease
