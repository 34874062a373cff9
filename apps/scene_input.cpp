// Reads the meshes that a scene names and throws InputError if a run could not work with them.
#include <fmt/format.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <map>

#include "apps/pinned_vertices.h"
#include "apps/resume.h"
#include "collision/body/mannequin.h"
#include "collision/triangle_tree.h"
#include "garment/builtin_garment.h"
#include "garment/comfort.h"
#include "garment/named_loop.h"
#include "garment/paint.h"
#include "solver/base/error.h"
#include "solver/io/mesh_io.h"
#include "solver/mesh/mesh_checks.h"
#include "solver/mesh/topology.h"

namespace ease {

namespace {

constexpr double kLowestPerson = 0.4;        // m: a newborn, curled up
constexpr double kTallestPerson = 2.6;       // m: arms raised
constexpr double kFarthestGarment = 0.5;     // m: distance between garment and body
constexpr double kDeepestGarment = 0.001;    // m inside the body: less may come from coarse meshes
constexpr double kLargestLimit = 0.5;        // stretch limit; no cloth stands more, 1.08 for 8 % is an error
constexpr double kMinProjectedGrain = 1e-6;  // length of a unit grain vector in a triangle's plane

std::filesystem::path besideScene(const Scene& scene, const std::string& file) {
  return (scene.file.parent_path() / file).lexically_normal();
}

/// Reads the mesh that a key of the scene names.
TriangleMesh readNamedMesh(const Scene& scene, const char* key, const std::string& file) {
  const std::filesystem::path path = besideScene(scene, file);
  if (!std::filesystem::exists(path))
    throw InputError(fmt::format("{}: {} = '{}': no such file: {}", scene.file.string(), key, file, path.string()));
  return readMesh(path);
}

/// Returns six times the volume that a closed mesh encloses, m^3; negative if its triangles face inwards.
double sixVolumes(const TriangleMesh& mesh) {
  double sum = 0.0;
  const Vec3 origin = mesh.positions.row(0);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Vec3 a = mesh.positions.row(mesh.triangles(t, 0)).transpose() - origin;
    const Vec3 b = mesh.positions.row(mesh.triangles(t, 1)).transpose() - origin;
    const Vec3 c = mesh.positions.row(mesh.triangles(t, 2)).transpose() - origin;
    sum += a.dot(b.cross(c));
  }
  return sum;
}

/// Checks that a body is closed and oriented outwards, so that it has an inside and an outside.  It may intersect
/// itself and may have several parts.
void checkBody(const TriangleMesh& mesh, const std::string& name) {
  int open_edges = 0;
  for (const Edge& edge : buildTopology(mesh, name).edges) open_edges += edge.isBoundary() ? 1 : 0;
  if (open_edges > 0)
    throw InputError(fmt::format("{}: {} boundary edges: expected a closed body, with an inside", name, open_edges));
  if (sixVolumes(mesh) <= 0.0)
    throw InputError(fmt::format("{}: inside out: expected triangles counter-clockwise seen from outside", name));
}

void warnOfHeight(const Positions& pose, const std::string& name, const Warn& warn) {
  const double height = pose.col(1).maxCoeff() - pose.col(1).minCoeff();
  if (height >= kLowestPerson && height <= kTallestPerson) return;
  warn(fmt::format("{}: {:.4g} m tall along y: a person is not; units? metres expected, y up", name, height));
}

void readFilePoses(const Scene& scene, const Warn& warn, const Pause& pause, SceneInput& input) {
  std::map<std::string, size_t> seen;  // repeated poses are read only once
  TriangleMesh first;
  std::string first_name;
  for (const std::string& file : scene.body->poses) {
    const auto [entry, is_new] = seen.emplace(file, input.poses.size());
    input.pose_names.push_back(std::filesystem::path(file).stem().string());
    if (!is_new) {
      input.poses.push_back(input.poses[entry->second]);
      continue;
    }
    pauseIn(pause);
    const std::string name = besideScene(scene, file).string();
    TriangleMesh pose = readNamedMesh(scene, "[body] poses", file);
    checkGeometry(pose, name);
    checkVerticesUsed(pose, name);
    if (input.poses.empty()) {
      first = pose;
      first_name = name;
    } else {
      if (scene.body->match_triangles) pose = matchByTriangles(first, first_name, pose, name);
      checkSameTriangles(first, first_name, pose, name);
    }
    checkBody(pose, name);
    warnOfHeight(pose.positions, name, warn);
    input.poses.push_back(std::move(pose.positions));
  }
  input.body_triangles = std::move(first.triangles);
}

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
    TriangleMesh pose = mannequin(name);
    input.body_triangles = std::move(pose.triangles);
    input.poses.push_back(std::move(pose.positions));
  }
}

void readPoses(const Scene& scene, const Warn& warn, const Pause& pause, const SceneInput* known, SceneInput& input) {
  if (known) {
    input.body_triangles = known->body_triangles;
    input.pose_names = known->pose_names;
    input.poses = known->poses;
  } else if (scene.body->builtin.empty()) {
    readFilePoses(scene, warn, pause, input);
  } else {
    makeBuiltinPoses(scene, pause, input);
  }
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
    input.garment = builtinGarment(garment.builtin, garment.vertices, offset);
    drawSeams(scene, "the built-in garment", input);
    return fmt::format("{}: [garment] builtin = '{}'", scene.file.string(), garment.builtin);
  }
  const std::filesystem::path file = besideScene(scene, garment.mesh);
  input.garment = readNamedMesh(scene, "[garment] mesh", garment.mesh);
  drawSeams(scene, file.string(), input);
  return file.string();
}

/// Checks that every triangle has a warp direction, which is the grain projected into its plane: a triangle at right
/// angles to the grain has none.
void checkGrain(const Scene& scene, const TriangleMesh& garment) {
  const Vec3& grain = scene.garment.grain;
  for (int t = 0; t < garment.triangles.rows(); ++t) {
    const Vec3 a = garment.positions.row(garment.triangles(t, 0));
    const Vec3 b = garment.positions.row(garment.triangles(t, 1));
    const Vec3 c = garment.positions.row(garment.triangles(t, 2));
    const Vec3 normal = doubleAreaNormal(a, b, c).normalized();
    if (normal.cross(grain).norm() >= kMinProjectedGrain) continue;
    throw InputError(
        fmt::format("{}: [garment] grain = [{:g}, {:g}, {:g}]: the normal of triangle {} of {} is parallel to it: "
                    "expected a grain that has a direction in every triangle",
                    scene.file.string(), grain.x(), grain.y(), grain.z(), t,
                    scene.garment.mesh.empty() ? "the garment" : scene.garment.mesh));
  }
}

/// Returns the smallest distance between a vertex and the body, m.
double distanceBetween(const Positions& positions, const TriangleTree& body) {
  double nearest = std::numeric_limits<double>::max();
  for (Eigen::Index v = 0; v < positions.rows(); ++v) {
    const ClosestPoint closest = body.closest(positions.row(v), nearest);
    if (closest.triangle >= 0) nearest = closest.distance;
  }
  return nearest;
}

/// Checks that the garment starts on the body: not far from it, and not inside, where contact could push vertices out
/// on the wrong side.
void checkStart(const SceneInput& input, const std::string& garment_name) {
  const TriangleTree body(input.poses.front(), input.body_triangles);
  double nearest = kFarthestGarment, deepest = 0.0;
  Eigen::Index deepest_vertex = 0;
  int inside = 0;
  const Positions& positions = input.garment.positions;
  for (Eigen::Index v = 0; v < positions.rows(); ++v) {
    const double distance = body.signedDistance(positions.row(v), kFarthestGarment);
    nearest = std::min(nearest, std::abs(distance));
    inside += distance < -kDeepestGarment ? 1 : 0;
    if (distance >= deepest) continue;
    deepest = distance;
    deepest_vertex = v;
  }
  const std::string& pose = input.pose_names.front();
  if (inside > 0)
    throw InputError(
        fmt::format("{}: {} of {} vertices lie inside the first pose, '{}', vertex {} deepest, {:.1f} mm: "
                    "expected a garment that starts outside the body",
                    garment_name, inside, positions.rows(), pose, deepest_vertex, -1000.0 * deepest));
  if (nearest >= kFarthestGarment)
    throw InputError(
        fmt::format("{}: at least {:.3g} m away from the first pose, '{}': expected a garment on the body, "
                    "at most {:g} m away at its nearest; units? metres expected",
                    garment_name, distanceBetween(positions, body), pose, kFarthestGarment));
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
  checkGrain(scene, input.garment);
  input.pins = pinnedVertices(scene, input, topology);
  if (!input.authored)
    input.offsets = ofGarment(scene, [&] {
      return comfortOffsets(input.garment.positions, scene.collision.offset, scene.garment.comfort_regions);
    });
  if (!scene.garment.paint.empty())
    input.paint = ofGarment(scene, [&] { return paintedScales(input.garment, scene.garment.paint); });

  if (!scene.body) return input;
  if (!scene.garment.tools) readPoses(scene, warn, pause, body, input);
  checkStart(input, name);
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
  ordered.authored.reset();
  ordered.loops.clear();
  ordered.seams.clear();
  ordered.offsets = renumbered(input.offsets, numbering.garment.vertices);
  ordered.paint = renumbered(input.paint, numbering.garment.triangles);
  ordered.body_triangles = renumbered(input.body_triangles, numbering.body);
  for (Positions& pose : ordered.poses) pose = renumbered(pose, numbering.body.vertices);
  return ordered;
}

}  // namespace ease
