#include "apps/studio/stage.h"

#include <cmath>
#include <limits>

#include "collision/triangle_tree.h"

namespace ease {

namespace {

constexpr double kBehind = 0.02;  // m: a point that lies no further behind what is seen counts as seen
constexpr double kNone = std::numeric_limits<double>::infinity();

/// Barycentric weights of a point of the triangle's plane.
Vec3 weightsOf(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = doubleAreaNormal(a, b, c);
  const double square = normal.squaredNorm();
  if (square == 0.0) return {1.0, 0.0, 0.0};
  const double wb = normal.dot((point - a).cross(c - a)) / square, wc = normal.dot((b - a).cross(point - a)) / square;
  return {1.0 - wb - wc, wb, wc};
}

std::optional<Hit> hitOn(const Ray& ray, const Positions& shown, const Triangles& triangles, const Positions& made) {
  const auto [place, distance] = firstHit(ray, shown, triangles);
  if (place.triangle < 0) return std::nullopt;
  const auto corners = triangles.row(place.triangle);
  Vec3 normal = doubleAreaNormal(shown.row(corners[0]), shown.row(corners[1]), shown.row(corners[2])).normalized();
  if (normal.dot(ray.direction) > 0.0) normal = -normal;
  return Hit{place, placeOn(place, shown, triangles), normal, placeOn(place, made, triangles), distance};
}

}  // namespace

Vec3 placeOn(const SurfacePlace& place, const Positions& positions, const Triangles& triangles) {
  Vec3 point = Vec3::Zero();
  for (int k = 0; k < 3; ++k) point += place.share[k] * positions.row(triangles(place.triangle, k)).transpose();
  return point;
}

SurfacePlace nearestPlace(const Vec3& point, const Positions& positions, const Triangles& triangles) {
  const TriangleTree tree(positions, triangles);
  const ClosestPoint closest = tree.closest(point, kNone);
  const auto corners = triangles.row(closest.triangle);
  return {closest.triangle,
          weightsOf(closest.point, positions.row(corners[0]), positions.row(corners[1]), positions.row(corners[2]))};
}

std::pair<SurfacePlace, double> firstHit(const Ray& ray, const Positions& positions, const Triangles& triangles) {
  std::pair<SurfacePlace, double> found{{}, kNone};
  const double* x = positions.data();
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {  // Moeller and Trumbore 1997
    const Eigen::Map<const Vec3> a(x + 3 * triangles(t, 0)), b(x + 3 * triangles(t, 1)), c(x + 3 * triangles(t, 2));
    const Vec3 ab = b - a, ac = c - a, p = ray.direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0.0) continue;
    const Vec3 from = ray.from - a;
    const double wb = from.dot(p) / determinant;
    if (wb < 0.0 || wb > 1.0) continue;
    const Vec3 q = from.cross(ab);
    const double wc = ray.direction.dot(q) / determinant;
    if (wc < 0.0 || wb + wc > 1.0) continue;
    const double distance = ac.dot(q) / determinant;
    if (distance > 0.0 && distance < found.second) found = {{static_cast<int>(t), {1.0 - wb - wc, wb, wc}}, distance};
  }
  return found;
}

void Stage::setBody(const Triangles& triangles, const Positions& first_pose) {
  body_triangles_ = triangles;
  first_pose_ = body_ = first_pose;
}

void Stage::setCloth(std::shared_ptr<const MadeGarment> made, const Positions& positions) {
  made_ = std::move(made);
  cloth_ = positions;
}

void Stage::removeCloth() {
  made_.reset();
  cloth_.resize(0, 3);
}

std::optional<Hit> Stage::hitBody(double x, double y) const {
  return hitOn(camera.through(x, y, size), body_, body_triangles_, first_pose_);
}

std::optional<Hit> Stage::hitCloth(double x, double y) const {
  if (!hasCloth()) return std::nullopt;
  const Ray ray = camera.through(x, y, size);
  const std::optional<Hit> hit = hitOn(ray, cloth_, clothAsMade().triangles, clothAsMade().positions);
  if (!hit || !hasBody()) return hit;
  const double body = firstHit(ray, body_, body_triangles_).second;
  return body < hit->distance - kBehind ? std::nullopt : hit;
}

double Stage::seenAt(double x, double y) const {
  const Ray ray = camera.through(x, y, size);
  double seen = hasBody() ? firstHit(ray, body_, body_triangles_).second : kNone;
  if (hasCloth()) seen = std::min(seen, firstHit(ray, cloth_, clothAsMade().triangles).second);
  return seen;
}

bool Stage::isAt(const Vec3& point, double x, double y) const {
  const Projected seen = project(point);
  if (seen.depth <= 0.0 || std::hypot(seen.x - x, seen.y - y) > kNearPixels) return false;
  return (point - camera.eye()).norm() <= seenAt(seen.x, seen.y) + kBehind;
}

std::optional<Vec3> Stage::seenOn(const std::vector<int>& line, bool is_closed, double x, double y,
                                  double& distance) const {
  std::optional<Vec3> nearest;
  for (size_t i = 0; i < line.size() - (is_closed ? 0 : 1); ++i) {
    const Vec3 a = cloth_.row(line[i]), b = cloth_.row(line[(i + 1) % line.size()]);
    for (const Vec3& point : {a, Vec3((a + b) / 2)}) {
      const Projected seen = project(point);
      const double off = std::hypot(seen.x - x, seen.y - y);
      if (seen.depth <= 0.0 || off >= distance || !isAt(point, x, y)) continue;
      distance = off;
      nearest = point;
    }
  }
  return nearest;
}

std::optional<LoopHit> Stage::hitLoop(double x, double y) const {
  if (!hasCloth()) return std::nullopt;
  std::optional<LoopHit> nearest;
  double distance = kNearPixels;
  for (size_t k = 0; k < made().edges.size(); ++k)
    if (const std::optional<Vec3> at = seenOn(made().edges[k].vertices, true, x, y, distance))
      nearest = LoopHit{static_cast<int>(k), *at};
  return nearest;
}

std::optional<int> Stage::hitSeam(double x, double y) const {
  if (!hasCloth() || !made().input.authored) return std::nullopt;
  std::optional<int> nearest;
  double distance = kNearPixels;
  const std::vector<Seam>& seams = made().input.authored->seams;
  for (size_t k = 0; k < seams.size(); ++k)
    if (seenOn(seams[k].vertices, seams[k].is_closed, x, y, distance)) nearest = static_cast<int>(k);
  return nearest;
}

}  // namespace ease
