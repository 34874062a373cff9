#include "apps/pose_files.h"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "collision/triangle_tree.h"
#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr double kFastestPerson = 8.0;  // m/s: hands and feet of athletes
constexpr double kWideMotion = 0.3;     // m: where no vertex moves further, no limb turns far
constexpr double kBuriedShare =
    0.01;  // of the body's vertices: more of them within another part on the way is no skin fold

/// Share of the vertices that lie inside another part of the body, and the mean of those, m.
std::pair<double, Vec3> buried(const Positions& x, const Triangles& triangles) {
  const TriangleTree tree(x, triangles);
  std::vector<int> triangle_of(x.rows(), -1);
  for (int t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) triangle_of[triangles(t, k)] = t;
  const int step = 1 + static_cast<int>(x.rows()) / 4000, count = (static_cast<int>(x.rows()) + step - 1) / step;
  std::vector<char> is_buried(count, 0);
  parallelFor(count, 16, [&](int k) {
    const int v = k * step;
    if (triangle_of[v] >= 0) is_buried[k] = tree.windingOutside(triangle_of[v], x.row(v)) > 0;
  });
  Vec3 sum = Vec3::Zero();
  int found = 0;
  for (int k = 0; k < count; ++k) {
    if (!is_buried[k]) continue;
    sum += x.row(static_cast<long>(k) * step).transpose();
    ++found;
  }
  return {found / static_cast<double>(count), found > 0 ? Vec3(sum / found) : sum};
}

double farthestMove(const Positions& from, const Positions& to) {
  return (to - from).rowwise().norm().maxCoeff();
}

}  // namespace

void checkMotion(const Scene& scene, const SceneInput& input, const Warn& warn) {
  if (input.poses.size() < 2) return;
  const double seconds = secondsPerPose(scene);
  double fastest = 0.0;
  size_t fastest_pose = 1;
  for (size_t p = 1; p < input.poses.size(); ++p) {
    const Positions &from = input.poses[p - 1], &to = input.poses[p];
    const double move = farthestMove(from, to);
    if (move / seconds > fastest) {
      fastest = move / seconds;
      fastest_pose = p;
    }
    if (move < kWideMotion) continue;
    const double at_ends = std::max(buried(from, input.body_triangles).first, buried(to, input.body_triangles).first);
    for (const double s : {0.25, 0.5, 0.75}) {
      Positions x;
      input.way->interpolations[p - 1].at(s, x);
      const auto [share, place] = buried(x, input.body_triangles);
      if (share - at_ends < kBuriedShare) continue;
      warn(fmt::format(
          "{}: [body] on the way from '{}' to '{}' a part of the body passes through another one, about "
          "({:.2f}, {:.2f}, {:.2f}), {:.0f} % of its surface at {:.0f} % of the way: put a pose in between that "
          "shows which way it goes",
          scene.file.string(), input.pose_names[p - 1], input.pose_names[p], place.x(), place.y(), place.z(),
          100.0 * share, 100.0 * s));
      break;
    }
  }
  if (fastest > kFastestPerson)
    warn(
        fmt::format("{}: [body] the surface moves at {:.3g} m/s from '{}' to '{}': people reach {:g} m/s; do the poses "
                    "stand in different places (align = true), or does it take longer (seconds_per_pose)?",
                    scene.file.string(), fastest, input.pose_names[fastest_pose - 1], input.pose_names[fastest_pose],
                    kFastestPerson));
}

}  // namespace ease
