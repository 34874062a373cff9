#include "apps/pose_files.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "apps/mesh_list.h"
#include "apps/weld_warnings.h"
#include "apps/words.h"
#include "collision/body/rigid_alignment.h"
#include "collision/triangle_tree.h"
#include "garment/hole_filling.h"
#include "solver/io/mesh_io.h"
#include "solver/mesh/mesh_checks.h"
#include "solver/mesh/weld.h"

namespace ease {

namespace {

constexpr double kLowestPerson = 0.4;        // m: a newborn, curled up
constexpr double kTallestPerson = 2.6;       // m: arms raised
constexpr double kMaxSizeRatio = 2.0;        // of a pose's lengths to the first pose's
constexpr double kHoleReach = 0.05;          // m: holes nearer to the garment than this are refused
constexpr double kSamePlace = 1e-4;          // m
constexpr double kFarthestFromOrigin = 1e7;  // m: beyond, whole voxels get lost in the numbers of a level set

// Poses that stand further apart than this are taken for scans that were not aligned.
constexpr double kWalk = 2.0, kMinShift = 0.3;                 // m/s, m
constexpr double kTurn = 2.5, kMinTurn = 50.0 / 180.0 * M_PI;  // rad/s, rad

/// The poses' files, each once, and what they hold.
struct Files {
  std::vector<std::string> names;  // as messages show them
  std::vector<Positions> poses;
  Triangles triangles;
  std::vector<size_t> of_pose;  // number of each pose's file
};

Files readFiles(const Scene& scene, const Pause& pause) {
  Files files;
  std::map<std::string, size_t> seen;
  Polygons first;
  Triangles cut;
  for (const std::string& file : scene.body->poses) {
    const auto [entry, is_new] = seen.emplace(file, files.poses.size());
    files.of_pose.push_back(entry->second);
    if (!is_new) continue;
    pauseIn(pause);
    const std::filesystem::path path = (scene.file.parent_path() / file).lexically_normal();
    if (!std::filesystem::exists(path))
      throw InputError(
          fmt::format("{}: [body] poses = '{}': no such file: {}", scene.file.string(), file, path.string()));
    files.names.push_back(path.string());
    Polygons polygons = readPolygons(path);
    if (files.poses.empty()) {
      cut = cutPolygons(polygons, path.string());
      files.triangles = trianglesOf(polygons, cut);
      files.poses.push_back(polygons.points);
      first = std::move(polygons);
      continue;
    }
    const bool alike = polygons.ends == first.ends;
    TriangleMesh pose{polygons.points, trianglesOf(polygons, alike ? cut : cutPolygons(polygons, path.string()))};
    const TriangleMesh of_first{files.poses.front(), files.triangles};
    if (scene.body->match_triangles) pose = matchByTriangles(of_first, files.names.front(), pose, path.string());
    checkSameTriangles(of_first, files.names.front(), pose, path.string());
    files.poses.push_back(std::move(pose.positions));
  }
  for (Positions& pose : files.poses) toMetres(scene.body->frame, pose);
  return files;
}

void weldPoses(const Scene& scene, const Warn& warn, Files& files) {
  const Weld weld = findWeld(files.triangles, files.poses, scene.body->weld);
  warnOfWeld(weld, files.names.front(), "body", warn);
  if (weld.changesNothing()) return;
  files.triangles = welded(files.triangles, weld);
  for (Positions& pose : files.poses) pose = welded(pose, weld);
}

double distanceToGarment(const Hole& hole, const Triangles& patch, const Positions& body, const Positions& garment) {
  const TriangleTree tree(body, patch);
  double nearest = 2.0 * kHoleReach;
  for (int v = 0; v < garment.rows(); ++v) {
    if ((garment.row(v).transpose() - hole.centre).norm() > hole.width_m + 2.0 * kHoleReach) continue;
    nearest = std::min(nearest, tree.closest(garment.row(v), nearest).distance);
  }
  return nearest;
}

/// How many vertices of the hole's edge are vertices of the garment.
long sharedWith(const Positions& garment, const Hole& hole, const Positions& body) {
  return std::count_if(hole.loop.begin(), hole.loop.end(), [&](int v) {
    return (garment.rowwise() - body.row(v)).rowwise().norm().minCoeff() < kSamePlace;
  });
}

void closeHoles(const Scene& scene, const Positions* garment, const Warn& warn, Files& files) {
  const std::string& name = files.names.front();
  const TriangleMesh body{files.poses.front(), files.triangles};
  const std::vector<Hole> holes = holesOf(body, buildTopology(body, name));
  std::vector<std::string> places;
  for (const Hole& hole : holes) {
    const std::string place = fmt::format("about ({:.3f}, {:.3f}, {:.3f}), {:.2g} m wide, {} edges", hole.centre.x(),
                                          hole.centre.y(), hole.centre.z(), hole.width_m, hole.loop.size());
    if (garment && 2 * sharedWith(*garment, hole, body.positions) > static_cast<long>(hole.loop.size()))
      throw InputError(fmt::format(
          "{}: the body has an open edge that is also the garment's, {}: the file seems to hold the garment, "
          "too; remove it from there",
          name, place));
    const Triangles patch = patchFor(hole, body.positions, name);
    if (garment && !scene.body->close_all && distanceToGarment(hole, patch, body.positions, *garment) < kHoleReach)
      throw InputError(
          fmt::format("{}: the body has a hole within {:g} m of the garment, {} ({} in all): close it in the "
                      "program that the mesh comes from, or let Ease close it: [body] holes = \"close\"",
                      name, kHoleReach, place, counted(static_cast<long>(holes.size()), "hole")));
    Triangles closed(files.triangles.rows() + patch.rows(), 3);
    closed << files.triangles, patch;
    files.triangles = std::move(closed);
    if (places.size() < 3) places.push_back(place);
  }
  if (!holes.empty())
    warn(fmt::format("{}: {} closed, as in every pose: {}{}", name,
                     counted(static_cast<long>(holes.size()), holes.size() == 1 ? "hole was" : "hole"),
                     fmt::join(places, "; "), places.size() < holes.size() ? "; ..." : ""));
}

/// Returns six times the volume that a closed mesh encloses, m^3; negative if its triangles face inwards.
double sixVolumes(const Positions& x, const Triangles& triangles) {
  double sum = 0.0;
  const Vec3 origin = x.row(0);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const Vec3 a = x.row(triangles(t, 0)).transpose() - origin, b = x.row(triangles(t, 1)).transpose() - origin,
               c = x.row(triangles(t, 2)).transpose() - origin;
    sum += a.dot(b.cross(c));
  }
  return sum;
}

/// Turns a body that faces inwards in all poses outwards; refuses one that does so in some.
void faceOutwards(const Warn& warn, Files& files) {
  const auto inwards = [&](const Positions& pose) { return sixVolumes(pose, files.triangles) <= 0.0; };
  const bool first = inwards(files.poses.front());
  for (size_t p = 1; p < files.poses.size(); ++p)
    if (inwards(files.poses[p]) != first)
      throw InputError(
          fmt::format("{}: is inside out where {} is not: is it mirrored? expected the same body, not its "
                      "mirror image",
                      files.names[p], files.names.front()));
  if (!first) return;
  if (sixVolumes(files.poses.front(), files.triangles) == 0.0)
    throw InputError(fmt::format("{}: encloses no volume: expected a body with an inside", files.names.front()));
  files.triangles.col(1).swap(files.triangles.col(2));
  warn(fmt::format("{}: inside out: its triangles face inwards and were turned over", files.names.front()));
}

void checkPlace(const Warn& warn, const Files& files) {
  for (size_t p = 0; p < files.poses.size(); ++p) {
    const double farthest = files.poses[p].cwiseAbs().maxCoeff();
    if (farthest > kFarthestFromOrigin)
      throw InputError(
          fmt::format("{}: lies {:.3g} m from the origin; expected at most {:g} m: move body and garment "
                      "there",
                      files.names[p], farthest, kFarthestFromOrigin));
  }
  for (size_t p = 0; p < files.poses.size(); ++p) {
    const Positions& pose = files.poses[p];
    const Vec3 size = (pose.colwise().maxCoeff() - pose.colwise().minCoeff()).transpose();
    const bool is_person = size.y() >= kLowestPerson && size.maxCoeff() <= kTallestPerson;
    const bool is_limb = size.maxCoeff() < kTallestPerson && size.maxCoeff() > 0.1 && size.y() > 0.5 * size.maxCoeff();
    if (is_person || is_limb) continue;
    const std::string advice = frameAdvice(size);
    const double width = std::max(size.x(), size.z());
    const std::string wide = width > size.y() ? fmt::format(" and {:.4g} m wide", width) : "";
    warn(fmt::format("{}: the body is {:.4g} m tall along y{}, unlike a person: check unit and axes (metres, y up){}",
                     files.names[p], size.y(), wide, advice.empty() ? "" : "; [body] " + advice));
    return;  // the others are told by the first
  }
}

/// Throws where a pose is much larger or smaller than the first, judged by the area of its surface, which hardly
/// changes with the posture.
void checkSameSize(const Files& files) {
  const auto length = [&](size_t p) { return std::sqrt(totalArea({files.poses[p], files.triangles})); };
  const double first = length(0);
  for (size_t p = 1; p < files.poses.size(); ++p) {
    const double ratio = length(p) / first;
    if (ratio < kMaxSizeRatio && ratio > 1.0 / kMaxSizeRatio) continue;
    throw InputError(
        fmt::format("{}: {:.3g} times as large as the first pose, '{}': poses of one person have one size; [body] unit "
                    "holds for all "
                    "files: convert this one",
                    files.names[p], ratio, files.names.front()));
  }
}

void alignPoses(const Scene& scene, const Warn& warn, SceneInput& input) {
  const BodyScene& body = *scene.body;
  if (body.align == false) return;
  const double seconds = secondsPerPose(scene);
  const double farthest = std::max(kMinShift, kWalk * seconds), widest = std::max(kMinTurn, kTurn * seconds);
  int moved = 0;
  std::string example;
  for (size_t p = 1; p < input.poses.size(); ++p) {
    const Standing standing = standingBetween(input.poses[p - 1], input.poses[p]);
    const bool far = standing.shift_m() > farthest || std::abs(standing.turn_rad) > widest;
    if (!far && body.align != true) continue;
    standAs(standing, input.poses[p]);
    if (++moved == 1)
      example = fmt::format("'{}' stood {:.2g} m and {:.0f} degrees from '{}'", input.pose_names[p], standing.shift_m(),
                            std::abs(standing.turn_rad) * 180.0 / M_PI, input.pose_names[p - 1]);
  }
  if (moved > 0 && body.align != true)
    warn(fmt::format(
        "{}: [body] {} further away than a person moves in {:.2g} s and was aligned to the one before it: {}; "
        "align = false keeps poses where they are",
        scene.file.string(), counted(moved, "pose"), seconds, example));
}

}  // namespace

void readFilePoses(const Scene& scene, const Positions* garment, const Warn& warn, const Pause& pause,
                   SceneInput& input) {
  Files files = readFiles(scene, pause);
  checkPlace(warn, files);
  weldPoses(scene, warn, files);
  for (size_t p = 0; p < files.poses.size(); ++p) checkGeometry({files.poses[p], files.triangles}, files.names[p]);
  checkSameSize(files);
  closeHoles(scene, garment, warn, files);
  faceOutwards(warn, files);
  for (size_t p = 0; p < scene.body->poses.size(); ++p) {
    input.pose_names.push_back(std::filesystem::path(scene.body->poses[p]).stem().string());
    input.poses.push_back(files.poses[files.of_pose[p]]);
  }
  input.body_triangles = std::move(files.triangles);
  alignPoses(scene, warn, input);
}

}  // namespace ease
