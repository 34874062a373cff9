// The scene file (TOML): what to simulate, on which body, and what to write.  The fields below have the units of the
// file's keys.
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "adaption/run_settings.h"
#include "apps/mesh_frame.h"
#include "apps/scene_pattern.h"
#include "collision/body/body_size.h"
#include "collision/body/pose_interpolation.h"
#include "collision/level_set.h"
#include "garment/authoring.h"
#include "solver/base/error.h"
#include "solver/mesh/numbering.h"
#include "solver/model/material.h"

namespace ease {

struct BodyScene {
  std::vector<std::string> poses;  // mesh files relative to the scene file, or names of the built-in body's poses
  std::string builtin;             // "mannequin"; empty: the poses are read from files
  BodyMeasures measures;           // of the built-in body
  int steps =
      Schedule().interpolation_steps;  // interpolation steps from one pose to the next; a single pose is held this long
  bool match_triangles = false;        // match = "triangles": match the poses' vertices by their triangles
  MeshFrame frame;                     // unit and axes of the files
  bool weld = true;                    // whether open edges at one place are closed (solver/mesh/weld.h)
  bool close_all = false;              // holes = "close": also those near the garment
  std::optional<bool> align;  // true: move every pose to where the one before stands; none: only those too far to walk
  double seconds_per_pose = 0.6;  // from one pose to the next, s; `steps` follow from it unless they are given
};

struct PinScene {
  std::variant<std::string, std::vector<int>, Brush> what;  // name of a loop, list of vertices, or a ball
  bool to_body = true;  // to = "body" | "fixed"; by default to the body if there is one
};

struct GarmentScene {
  MeshFrame frame;                       // unit and axes of the file
  bool weld = true;                      // as in BodyScene
  std::string mesh;                      // file relative to the scene file; empty: built-in or made by tools
  std::string builtin;                   // "t-shirt", "dress"
  int vertices = 3000;                   // approximate number of vertices of the built-in garment
  std::optional<GarmentTools> tools;     // tools that make the garment on the first pose, instead of mesh or builtin
  std::vector<SeamRequest> seams;        // of a mesh or a built-in garment; those of a made one are among the tools
  std::vector<Brush> paint;              // scale factors of the rest shape
  std::optional<double> comfort_offset;  // m; copied to CollisionScene
  std::vector<Brush> comfort_regions;    // offsets, m
  Vec3 grain = {0.0, -1.0, 0.0};         // warp direction
  std::vector<PinScene> pins;
  bool is_draft = false;  // no garment can be made of it yet (readDraft)
};

struct SolverScene {
  Method method = MethodOptions().method;
  double tolerance = MethodOptions().tolerance;    // pd-lbfgs, auto: relative error of a step
  double residual = MethodOptions().residual;      // newton: largest residual acceleration, m/s^2
  int iterations = MethodOptions().iterations;     // pd
  double time_step = Schedule().time_step;         // s
  int steps_per_pose = Schedule().steps_per_pose;  // time steps for each interpolation step
  int steps = 0;                                   // number of time steps, for a scene without a body
  Vec3 gravity = RunSettings().gravity;            // m/s^2
  int threads = 0;                                 // 0: as many as the machine has
};

struct CollisionScene {
  double offset = RunSettings().comfort_offset;        // comfort offset: smallest distance to the body, m
  double voxel = LevelSetOptions().voxel;              // voxel size of the level set, m
  double stiffness = RunSettings().contact_stiffness;  // contact pressure per depth, N/m^3
  double friction = RunSettings().friction;            // coefficient of friction between garment and body
};

enum class AdaptionMode {
  passes,      // whole motions on a fixed rest shape, which is let out between them (adaption/fit.h)
  sequential,  // the rest shape is let out while the body moves, after Wolff et al. 2022
};

struct AdaptionScene {
  double limit = 0.1;  // delta: principal stretch at most 1 + delta
  int every = 8;       // time steps between measurements of the stretch
  int cycles = 1;      // number of times that the motion is run through
  int settle = 0;      // additional time steps on the last pose
  bool verify = true;  // sequential: replay the motion with the first and with the adapted rest shape
  AdaptionMode mode = AdaptionMode::passes;
  FitSettings fit;  // passes: target and number
};

struct OutputScene {
  int every = 8;         // time steps per written frame
  bool replays = false;  // the replays on the first and on the adapted rest shape are written, too
};

struct Scene {
  std::filesystem::path file;
  std::string name;  // name of the scene and of its result folder; by default the file's name
  std::optional<BodyScene> body;
  GarmentScene garment;
  Material material;
  SolverScene solver;
  CollisionScene collision;
  std::optional<AdaptionScene> adaption;
  std::optional<OutputScene> output;
  PatternScene pattern;
  std::map<std::string, std::string> tables_of_run;  // as the file has them, but for names of files (run_inputs.h)
};

/// Whether the scene's rest shape is fitted in passes.
inline bool fitsInPasses(const Scene& scene) {
  return scene.adaption && scene.adaption->mode == AdaptionMode::passes;
}

/// Whether the scene asks for series of the replays.
inline bool writesReplays(const Scene& scene) {
  return scene.output && scene.output->replays;
}

/// Reads a scene.  Throws InputError with file, line, key, the value found and what was expected: unknown keys (with
/// the nearest known one), wrong types, impossible values, missing tables, keys that exclude each other.
/// `names_folder`: its name must be one that a folder can have.
Scene readScene(const std::filesystem::path& file, bool names_folder = true);

/// Time from one pose of the body to the next, s.
inline double secondsPerPose(const Scene& scene) {
  return scene.body ? scene.body->steps * scene.solver.steps_per_pose * scene.solver.time_step : 0.0;
}

/// The garment as its file has it, kept where vertices were welded or left out.
struct GarmentAsRead {
  TriangleMesh mesh;
  std::vector<int> vertex;  // of the garment, for each vertex of the file; -1: none
};

/// Reads a scene that is still being made, from the text of a file that need not exist: it may lack a garment, or have
/// boundaries and no region yet.  Throws as readScene() does.
Scene readDraft(const std::string& text, const std::filesystem::path& file);

/// The meshes and other data that a scene refers to, read and checked.
struct SceneInput {
  TriangleMesh garment;
  Positions start;  // where the garment begins, m; empty: at `garment`
  std::optional<GarmentAsRead> as_read;
  Triangles body_triangles;  // empty: no body
  std::vector<std::string> pose_names;
  std::vector<Positions> poses;                  // same order as pose_names
  std::shared_ptr<const InterpolatedPoses> way;  // of the body through its poses; null: no body, or not computed
  std::vector<std::vector<int>> pins;            // vertices of each [[garment.pin]]
  std::optional<AuthoredGarment> authored;
  std::vector<NamedLoop> loops;       // of the garment; empty where it is read or built in and has no seams
  std::vector<Seam> seams;            // of the garment
  std::vector<double> offsets;        // comfort offset of every vertex of the garment, m
  std::vector<double> paint;          // scale factor of every triangle's rest shape; empty: no paint
  std::vector<std::string> warnings;  // one line each
};

/// Where the garment's vertices begin, m.
inline const Positions& startOf(const SceneInput& input) {
  return input.start.rows() > 0 ? input.start : input.garment.positions;
}

/// Number that a vertex of the garment has in its file: the first one that became it.
inline int fileVertex(const SceneInput& input, int vertex) {
  if (!input.as_read) return vertex;
  const std::vector<int>& of_file = input.as_read->vertex;
  return static_cast<int>(std::find(of_file.begin(), of_file.end(), vertex) - of_file.begin());
}

/// Function that receives a warning of one line.
using Warn = std::function<void(const std::string&)>;

/// The garment that a run began with, on the first pose, in its original numbering.
struct StartGarment {
  TriangleMesh mesh;
  double offset = 0.0;  // comfort offset for which a built-in garment was made, m
};

/// Reads the meshes or makes the garment with the scene's tools, and checks everything that a run relies on.  Throws
/// InputError.  `tell` receives every warning as soon as it is known, because a later error may have the same cause.
/// `before` is the start garment of a run to be resumed: the scene's garment must have its triangles and gets its
/// positions.  `pause` is called between meshes and between tools.  `body`: an earlier input of the same [body], whose
/// poses are taken over, and whose motion checkMotion() has seen.
SceneInput readSceneInput(const Scene& scene, const Warn& tell = nullptr, const StartGarment* before = nullptr,
                          const Pause& pause = nullptr, const SceneInput* body = nullptr);

/// Reads or makes the poses of the scene's body alone.
SceneInput readBodyInput(const Scene& scene, const Warn& tell = nullptr);

/// The order in which a run stores the vertices and triangles of its meshes.
struct InputNumbering {
  Numbering garment, body;
};

/// Numbers vertices and triangles along a space-filling curve, those of the body by their places in its first pose.
InputNumbering spatialNumbering(const SceneInput& input);

/// Returns the input in another order of vertices and triangles.  `authored`, `loops` and `seams` are left empty.
SceneInput renumbered(const SceneInput& input, const InputNumbering& numbering);

}  // namespace ease
