// Reads the meshes that a scene names and refuses what a run could not work with.
#include <fmt/format.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "apps/resume.h"
#include "apps/scene.h"
#include "apps/words.h"
#include "collision/mannequin.h"
#include "collision/triangle_tree.h"
#include "garment/builtin_garment.h"
#include "garment/comfort.h"
#include "garment/paint.h"
#include "solver/mesh/error.h"
#include "solver/mesh/mesh_checks.h"
#include "solver/mesh/mesh_io.h"
#include "solver/mesh/topology.h"

namespace ease {

namespace {

constexpr double kLowestPerson = 0.4;          // m: a newborn, curled up
constexpr double kTallestPerson = 2.6;         // m: arms raised
constexpr double kFarthestGarment = 0.5;       // m from the body, at its nearest
constexpr double kDeepestGarment = 0.001;      // m inside the body: less is the roundness of meshes
constexpr double kLeastProjectedGrain = 1e-6;  // of a unit grain, in a triangle's plane

std::filesystem::path besideScene(const Scene& scene, const std::string& file) {
  return (scene.file.parent_path() / file).lexically_normal();
}

/// The mesh that a key of the scene names.
TriangleMesh readNamedMesh(const Scene& scene, const char* key, const std::string& file) {
  const std::filesystem::path path = besideScene(scene, file);
  if (!std::filesystem::exists(path))
    throw InputError(fmt::format("{}: {} = '{}': no such file: {}", scene.file.string(), key, file, path.string()));
  return readMesh(path);
}

/// Six times the volume that a closed mesh encloses, m^3; negative if its triangles face inwards.
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

/// A body has an inside and an outside.  It may overlap itself and may have several parts.
void checkBody(const TriangleMesh& mesh, const std::string& name) {
  int open_edges = 0;
  for (const Edge& edge : buildTopology(mesh, name).edges) open_edges += edge.isBoundary() ? 1 : 0;
  if (open_edges > 0)
    throw InputError(fmt::format("{}: {} boundary edges: expected a closed body, with an inside", name, open_edges));
  if (sixVolumes(mesh) <= 0.0)
    throw InputError(fmt::format("{}: inside out: expected triangles counter-clockwise seen from outside", name));
}

void warnOfHeight(const Positions& pose, const std::string& name, std::vector<std::string>& warnings) {
  const double height = pose.col(1).maxCoeff() - pose.col(1).minCoeff();
  if (height >= kLowestPerson && height <= kTallestPerson) return;
  warnings.push_back(
      fmt::format("{}: {:.3g} m tall along y: a person is not; units? metres expected, y up", name, height));
}

void readFilePoses(const Scene& scene, SceneInput& input) {
  std::map<std::string, size_t> seen;  // poses that return are read once
  TriangleMesh first;
  std::string first_name;
  for (const std::string& file : scene.body->poses) {
    const auto [entry, is_new] = seen.emplace(file, input.poses.size());
    input.pose_names.push_back(std::filesystem::path(file).stem().string());
    if (!is_new) {
      input.poses.push_back(input.poses[entry->second]);
      continue;
    }
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
    warnOfHeight(pose.positions, name, input.warnings);
    input.poses.push_back(std::move(pose.positions));
  }
  input.body_triangles = std::move(first.triangles);
}

void makeBuiltinPoses(const Scene& scene, SceneInput& input) {
  std::map<std::string, size_t> seen;
  for (const std::string& name : scene.body->poses) {
    const auto [entry, is_new] = seen.emplace(name, input.poses.size());
    input.pose_names.push_back(name);
    if (!is_new) {
      input.poses.push_back(input.poses[entry->second]);
      continue;
    }
    TriangleMesh pose = mannequin(name);
    input.body_triangles = std::move(pose.triangles);
    input.poses.push_back(std::move(pose.positions));
  }
}

void readPoses(const Scene& scene, SceneInput& input) {
  if (scene.body->builtin.empty()) {
    readFilePoses(scene, input);
  } else {
    makeBuiltinPoses(scene, input);
  }
}

/// Reads or makes the garment; returns what to call it in messages.  `offset`: that a built-in one is made for, m.
std::string readGarment(const Scene& scene, double offset, SceneInput& input) {
  const GarmentScene& garment = scene.garment;
  if (garment.tools) {
    try {
      input.authored = authorGarment({input.poses.front(), input.body_triangles}, *garment.tools,
                                     {scene.collision.offset, garment.comfort_regions});
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: [garment] {}", scene.file.string(), error.what()));
    }
    input.garment = input.authored->garment.mesh;
    input.offsets = input.authored->offsets;
    return "garment";
  }
  if (!garment.builtin.empty()) {
    input.garment = builtinGarment(garment.builtin, garment.vertices, offset);
    return garment.builtin;
  }
  const std::filesystem::path file = besideScene(scene, garment.mesh);
  input.garment = readNamedMesh(scene, "[garment] mesh", garment.mesh);
  return file.string();
}

void paint(const Scene& scene, SceneInput& input) {
  if (scene.garment.paint.empty()) return;
  try {
    input.paint = paintedScales(input.garment, scene.garment.paint);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: [garment] {}", scene.file.string(), error.what()));
  }
}

/// Warp is the grain projected into each triangle; a triangle square to the grain would have none.
void checkGrain(const TriangleMesh& garment, const Vec3& grain, const std::string& name) {
  for (int t = 0; t < garment.triangles.rows(); ++t) {
    const Vec3 a = garment.positions.row(garment.triangles(t, 0));
    const Vec3 b = garment.positions.row(garment.triangles(t, 1));
    const Vec3 c = garment.positions.row(garment.triangles(t, 2));
    const Vec3 normal = doubleAreaNormal(a, b, c).normalized();
    if (normal.cross(grain).norm() >= kLeastProjectedGrain) continue;
    throw InputError(
        fmt::format("{}: triangle {}: its normal is parallel to grain = [{:g}, {:g}, {:g}]: expected a grain "
                    "that has a direction in every triangle",
                    name, t, grain.x(), grain.y(), grain.z()));
  }
}

/// Distance of the nearest vertex, m.
double distanceBetween(const Positions& positions, const TriangleTree& body) {
  double nearest = std::numeric_limits<double>::max();
  for (Eigen::Index v = 0; v < positions.rows(); ++v) {
    const ClosestPoint closest = body.closest(positions.row(v), nearest);
    if (closest.triangle >= 0) nearest = closest.distance;
  }
  return nearest;
}

/// The garment starts on the body: not elsewhere, and not inside, where contact would push it out on any side.
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

/// A loop by the name that it was authored with, or by where it lies.
std::vector<int> loopNamed(const std::string& name, const SceneInput& input, const Topology& topology) {
  if (!input.authored) return findLoop(topology, input.garment.positions, name);
  std::vector<std::string> names;
  for (const NamedLoop& loop : input.authored->garment.loops) {
    if (loop.name == name) return loop.vertices;
    names.push_back(loop.name);
  }
  throw InputError(fmt::format("loop = '{}': expected {}", name, listWords(names)));
}

std::vector<int> verticesIn(const Brush& ball, const Positions& positions) {
  std::vector<int> vertices;
  for (int v = 0; v < positions.rows(); ++v)
    if ((Vec3(positions.row(v)) - ball.at).norm() <= ball.radius) vertices.push_back(v);
  if (vertices.empty())
    throw InputError(fmt::format("at = [{:g}, {:g}, {:g}], radius = {:g}: no vertex of the garment lies in this ball",
                                 ball.at.x(), ball.at.y(), ball.at.z(), ball.radius));
  return vertices;
}

std::vector<std::vector<int>> resolvePins(const Scene& scene, const SceneInput& input, const Topology& topology,
                                          const std::string& garment_name) {
  const TriangleMesh& garment = input.garment;
  std::vector<std::vector<int>> pins;
  std::set<int> pinned;
  for (const PinScene& pin : scene.garment.pins) {
    const std::string where = fmt::format("{}: [[garment.pin]] number {}", scene.file.string(), pins.size() + 1);
    try {
      if (const auto* loop = std::get_if<std::string>(&pin.what)) {
        pins.push_back(loopNamed(*loop, input, topology));
      } else if (const auto* ball = std::get_if<Brush>(&pin.what)) {
        pins.push_back(verticesIn(*ball, garment.positions));
      } else {
        pins.push_back(std::get<std::vector<int>>(pin.what));
      }
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", where, error.what()));
    }
    for (const int v : pins.back()) {
      if (v >= garment.positions.rows())
        throw InputError(fmt::format("{}: vertex {}: expected 0 to {}, the vertices of {}", where, v,
                                     garment.positions.rows() - 1, garment_name));
      if (!pinned.insert(v).second) throw InputError(fmt::format("{}: vertex {} is pinned twice", where, v));
    }
  }
  return pins;
}

}  // namespace

SceneInput readSceneInput(const Scene& scene, const StartGarment* before) {
  SceneInput input;
  // A garment that is authored needs its body; otherwise its faults are told first.
  if (scene.garment.tools) readPoses(scene, input);
  const std::string name = readGarment(scene, before ? before->offset : scene.collision.offset, input);
  if (before) startAs(*before, name, input);
  checkGeometry(input.garment, name);
  checkVerticesUsed(input.garment, name);
  const Topology topology = buildTopology(input.garment, name);
  checkGrain(input.garment, scene.garment.grain, name);
  input.pins = resolvePins(scene, input, topology, name);
  if (!input.authored)
    input.offsets = comfortOffsets(input.garment.positions, scene.collision.offset, scene.garment.comfort_regions);
  paint(scene, input);

  if (!scene.body) return input;
  if (!scene.garment.tools) readPoses(scene, input);
  checkStart(input, name);
  return input;
}

SceneInput renumbered(const SceneInput& input, const Numbering& numbering) {
  const std::vector<int> number = newNumbers(numbering.vertices);
  SceneInput ordered = input;
  ordered.garment = renumbered(input.garment, numbering);
  for (std::vector<int>& pin : ordered.pins)
    for (int& v : pin) v = number[v];
  ordered.authored.reset();
  ordered.offsets = renumbered(input.offsets, numbering.vertices);
  ordered.paint = renumbered(input.paint, numbering.triangles);
  return ordered;
}

}  // namespace ease
