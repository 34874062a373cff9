// Reads the meshes that a scene names and throws InputError if a run could not work with them.
#include <fmt/format.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <map>

#include "apps/garment_file.h"
#include "apps/pinned_vertices.h"
#include "apps/pose_files.h"
#include "apps/resume.h"
#include "apps/start_check.h"
#include "collision/body/mannequin.h"
#include "garment/builtin_garment.h"
#include "garment/comfort.h"
#include "garment/named_loop.h"
#include "garment/paint.h"
#include "solver/base/error.h"
#include "solver/mesh/mesh_checks.h"
#include "solver/mesh/topology.h"
#include "solver/model/warp.h"

namespace ease {

namespace {

constexpr double kLargestLimit = 0.5;  // stretch limit; no cloth stands more, 1.08 for 8 % is an error

void makeBuiltinPoses(const Scene& scene, const Pause& pause, SceneInput& input) {
  std::map<std::string, size_t> seen;
  for (const std::string& name : scene.body->poses) {
    const auto [entry, is_new] = seen.emplace(name, input.poses.size());
    input.pose_names.push_back(name);
    if (!is_new) {
      input.poses.push_back(input.poses[entry->second]);
      continue;
    }
    pauseIn(pause);
    TriangleMesh pose = mannequin(name, scene.body->measures);
    input.body_triangles = std::move(pose.triangles);
    input.poses.push_back(std::move(pose.positions));
  }
}

void readPoses(const Scene& scene, const Warn& warn, const Pause& pause, const SceneInput* known, SceneInput& input) {
  if (known) {
    input.body_triangles = known->body_triangles;
    input.pose_names = known->pose_names;
    input.poses = known->poses;
    input.way = known->way;
    return;
  }
  if (scene.body->builtin.empty()) {
    // readBodyInput() has no garment, and tools have not made theirs yet
    const bool has_garment = !scene.garment.tools && input.garment.positions.rows() > 0;
    readFilePoses(scene, has_garment ? &input.garment.positions : nullptr, warn, pause, input);
  } else {
    makeBuiltinPoses(scene, pause, input);
  }
  input.way = std::make_shared<const InterpolatedPoses>(input.body_triangles, input.poses);
}

/// Returns the result of `make()`.  Puts the scene's file and "[garment]" before the message of an InputError.
template <class Make>
auto ofGarment(const Scene& scene, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: [garment] {}", scene.file.string(), error.what()));
  }
}

/// Draws the seams of a garment that no tools made; its vertices near them slide within its surface.
void drawSeams(const Scene& scene, const std::string& name, SceneInput& input) {
  if (scene.garment.seams.empty()) return;
  checkGeometry(input.garment, name);
  checkVerticesUsed(input.garment, name);
  const Topology topology = buildTopology(input.garment, name);
  LoopedMesh looped{input.garment, nameLoops(topology, input.garment.positions)};
  input.seams = ofGarment(scene, [&] { return findSeams(scene.garment.seams, looped); });
  input.garment = looped.mesh;
  input.loops = looped.loops;
}

/// Reads or makes the garment and returns its name for messages.  `offset`: comfort offset for which a built-in garment
/// is made, m.
std::string readGarment(const Scene& scene, double offset, const Warn& warn, const Pause& pause, SceneInput& input) {
  const GarmentScene& garment = scene.garment;
  if (garment.tools) {
    input.authored = ofGarment(scene, [&] {
      return authorGarment({input.poses.front(), input.body_triangles}, *garment.tools,
                           {scene.collision.offset, garment.comfort_regions}, pause);
    });
    const std::string name = scene.file.string() + ": [garment]";
    for (const std::string& flaw : flawsOf(input.authored->quality)) warn(name + " as made: " + flaw);
    input.garment = input.authored->garment.mesh;
    input.offsets = input.authored->offsets;
    input.loops = input.authored->garment.loops;
    input.seams = input.authored->seams;
    return name;
  }
  if (!garment.builtin.empty()) {
    input.garment = ofGarment(
        scene, [&] { return builtinGarment(garment.builtin, garment.vertices, offset, scene.body->measures); });
    drawSeams(scene, "the built-in garment", input);
    return fmt::format("{}: [garment] builtin = '{}'", scene.file.string(), garment.builtin);
  }
  const std::string name = readGarmentFile(scene, warn, input);
  drawSeams(scene, name, input);
  return name;
}

}  // namespace

SceneInput readSceneInput(const Scene& scene, const Warn& tell, const StartGarment* before, const Pause& pause,
                          const SceneInput* body) {
  SceneInput input;
  const Warn warn = [&](const std::string& warning) {
    input.warnings.push_back(warning);
    if (tell) tell(warning);
  };
  if (scene.adaption && scene.adaption->limit > kLargestLimit)
    warn(
        fmt::format("{}: [adaption] limit = {:g}: cloth stretched up to {:g} times its length stays as it is; 0.08 "
                    "stands for 8 %",
                    scene.file.string(), scene.adaption->limit, 1.0 + scene.adaption->limit));
  // Tools need the body before they can make a garment.  Otherwise the garment is read and checked before the body.
  if (scene.garment.tools) readPoses(scene, warn, pause, body, input);
  const std::string name = readGarment(scene, before ? before->offset : scene.collision.offset, warn, pause, input);
  if (before) takeStartFrom(*before, name, warn, input);
  checkGeometry(input.garment, name);
  checkVerticesUsed(input.garment, name);
  const Topology topology = buildTopology(input.garment, name);
  tellParts(input.garment, name, warn);
  ofGarment(scene, [&] { return warpDirections(input.garment, topology, scene.garment.grain); });
  input.pins = pinnedVertices(scene, input, topology);
  if (!input.authored)
    input.offsets = ofGarment(scene, [&] {
      return comfortOffsets(input.garment.positions, scene.collision.offset, scene.garment.comfort_regions);
    });
  if (!scene.garment.paint.empty())
    input.paint = ofGarment(scene, [&] { return paintedScales(input.garment, scene.garment.paint); });

  if (!scene.body) return input;
  if (!scene.garment.tools) readPoses(scene, warn, pause, body, input);
  if (!body) checkMotion(scene, input, warn);
  checkStart(name, warn, input);
  return input;
}

SceneInput readBodyInput(const Scene& scene, const Warn& tell) {
  SceneInput input;
  const Warn warn = [&](const std::string& warning) {
    input.warnings.push_back(warning);
    if (tell) tell(warning);
  };
  if (scene.body) readPoses(scene, warn, nullptr, nullptr, input);
  return input;
}

InputNumbering spatialNumbering(const SceneInput& input) {
  InputNumbering numbering;
  numbering.garment = spatialNumbering(input.garment);
  if (!input.poses.empty()) numbering.body = spatialNumbering(TriangleMesh{input.poses.front(), input.body_triangles});
  return numbering;
}

SceneInput renumbered(const SceneInput& input, const InputNumbering& numbering) {
  const std::vector<int> number = newNumbers(numbering.garment.vertices);
  SceneInput ordered = input;
  ordered.garment = renumbered(input.garment, numbering.garment);
  for (std::vector<int>& pin : ordered.pins)
    for (int& v : pin) v = number[v];
  if (input.start.rows() > 0) ordered.start = renumbered(input.start, numbering.garment.vertices);
  ordered.authored.reset();
  ordered.loops.clear();
  ordered.seams.clear();
  if (!input.offsets.empty()) ordered.offsets = renumbered(input.offsets, numbering.garment.vertices);
  if (!input.paint.empty()) ordered.paint = renumbered(input.paint, numbering.garment.triangles);
  ordered.body_triangles = renumbered(input.body_triangles, numbering.body);
  for (Positions& pose : ordered.poses) pose = renumbered(pose, numbering.body.vertices);
  if (input.way)
    ordered.way = std::make_shared<const InterpolatedPoses>(renumbered(*input.way, numbering.body.vertices));
  return ordered;
}

}  // namespace ease
