// The scene file: what to simulate, on which body, and what to write.  TOML; every key has its unit here.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "adaption/run.h"
#include "garment/authoring.h"
#include "solver/base/error.h"
#include "solver/mesh/numbering.h"
#include "solver/model/material.h"

namespace ease {

struct BodyScene {
  std::vector<std::string> poses;  // mesh files relative to the scene file, or names of the built-in body's poses
  std::string builtin;             // "mannequin", or empty: files
  int steps =
      Schedule()
          .interpolation_steps;  // interpolation steps from a pose to the next; with one pose, how long it is held
  bool match_triangles = false;  // match = "triangles"
};

struct PinScene {
  std::variant<std::string, std::vector<int>, Brush> what;  // loop, or vertices, or those in a ball
  bool to_body = true;  // to = "body" | "fixed"; by default to the body if there is one
};

struct GarmentScene {
  std::string mesh;                      // file relative to the scene file, or empty: built in
  std::string builtin;                   // "t-shirt", "dress"
  int vertices = 3000;                   // of the built-in garment
  std::optional<GarmentTools> tools;     // the garment is made on the first pose; otherwise mesh or builtin
  std::vector<Brush> paint;              // scale factors of the rest shape
  std::optional<double> comfort_offset;  // m; stands in CollisionScene too
  std::vector<Brush> comfort_regions;    // offsets, m
  Vec3 grain = {0.0, -1.0, 0.0};         // warp direction
  std::vector<PinScene> pins;
};

struct SolverScene {
  Method method = MethodOptions().method;
  double tolerance = MethodOptions().tolerance;    // pd-lbfgs, auto: relative error of a step
  double residual = MethodOptions().residual;      // newton: largest residual acceleration, m/s^2
  int iterations = MethodOptions().iterations;     // pd
  double time_step = Schedule().time_step;         // s
  int steps_per_pose = Schedule().steps_per_pose;  // time steps for each interpolation step
  int steps = 0;                                   // time steps of a scene without a body
  Vec3 gravity = RunSettings().gravity;            // m/s^2
  int threads = 0;                                 // 0: all
};

struct CollisionScene {
  double offset = RunSettings().comfort_offset;        // comfort: least distance to the body, m
  double voxel = LevelSetOptions().voxel;              // m
  double stiffness = RunSettings().contact_stiffness;  // contact pressure per depth, N/m^3
};

struct AdaptionScene {
  double limit = 0.1;  // delta: principal stretch at most 1 + delta
  int every = 8;       // time steps
  int cycles = 1;      // times through the motion
  int settle = 0;      // time steps more on the last pose
  bool verify = true;  // replay the motion on the first and on the adapted rest shape
};

struct OutputScene {
  int every = 8;  // time steps per written frame
};

struct Scene {
  std::filesystem::path file;
  std::string name;  // of the scene and of its folder of results; by default the file's
  std::optional<BodyScene> body;
  GarmentScene garment;
  Material material;
  SolverScene solver;
  CollisionScene collision;
  std::optional<AdaptionScene> adaption;
  std::optional<OutputScene> output;
};

/// Reads a scene.  Throws InputError with file, line, key, the value found and what was expected: unknown keys (with
/// the nearest known one), wrong types, impossible values, missing tables, keys that exclude each other.
Scene readScene(const std::filesystem::path& file);

/// What a scene names, read and checked.
struct SceneInput {
  TriangleMesh garment;
  Triangles body_triangles;  // empty: no body
  std::vector<std::string> pose_names;
  std::vector<Positions> poses;        // same order as pose_names
  std::vector<std::vector<int>> pins;  // vertices of each [[garment.pin]]
  std::optional<AuthoredGarment> authored;
  std::vector<double> offsets;        // comfort at every vertex of the garment, m
  std::vector<double> paint;          // scale factor of every triangle's rest shape; empty: none is painted
  std::vector<std::string> warnings;  // one line each
};

/// What to do with a warning, one line.
using Warn = std::function<void(const std::string&)>;

/// The garment that a run began with, on the first pose, numbered as it came.
struct StartGarment {
  TriangleMesh mesh;
  double offset = 0.0;  // m: that a built-in one was made for
};

/// Reads meshes and checks all that a run relies on; makes the garment that has tools.  Throws InputError.  `tell`: is
/// given every warning as soon as it is known, since what follows may fail for the same reason.  `before`: of a run
/// that goes on; the scene's garment must have its triangles, and takes its positions.  `pause`: between meshes and
/// tools.
SceneInput readSceneInput(const Scene& scene, const Warn& tell = nullptr, const StartGarment* before = nullptr,
                          const Pause& pause = nullptr);

/// In which order a run has the vertices and triangles of its meshes.
struct InputNumbering {
  Numbering garment, body;
};

/// Along a curve through space; the body's as it is in its first pose.
InputNumbering spatialNumbering(const SceneInput& input);

/// The same meshes in another order; without what authoring alone knows.
SceneInput renumbered(const SceneInput& input, const InputNumbering& numbering);

}  // namespace ease
