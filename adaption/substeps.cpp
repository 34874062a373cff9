#include "adaption/substeps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/base/error.h"
#include "solver/base/joined.h"

namespace ease {

namespace {

constexpr double kMargin = 0.05;  // m: beyond the garment's bounding box the body's motion does not matter
constexpr int kMaxParts = 256;
constexpr double kMinOffset = 0.005;            // m: smaller comfort offsets count as this one
constexpr double kMaxMotionPerLevelSet = 0.03;  // m, from a level set to the next

}  // namespace

double bodyMotionPerStep(const Schedule& schedule, const Triangles& body, const std::vector<Positions>& poses,
                         const Positions& garment) {
  if (poses.size() < 2) return 0.0;
  Eigen::AlignedBox3d near_garment;
  for (int i = 0; i < garment.rows(); ++i) near_garment.extend(garment.row(i).transpose());
  near_garment.min().array() -= kMargin;
  near_garment.max().array() += kMargin;
  std::vector<char> is_near(poses.front().rows(), 0);
  for (int t = 0; t < body.rows(); ++t) {
    Eigen::AlignedBox3d triangle;
    for (int corner = 0; corner < 3; ++corner) triangle.extend(poses.front().row(body(t, corner)).transpose());
    if (!near_garment.intersects(triangle)) continue;
    for (int corner = 0; corner < 3; ++corner) is_near[body(t, corner)] = 1;
  }
  double furthest = 0.0;  // from a pose to the next, m
  for (size_t p = 0; p + 1 < poses.size(); ++p)
    for (int i = 0; i < poses.front().rows(); ++i)
      if (is_near[i]) furthest = std::max(furthest, (poses[p + 1].row(i) - poses[p].row(i)).norm());
  return furthest / (schedule.interpolation_steps * schedule.steps_per_pose);
}

Substeps chooseSubsteps(const Schedule& schedule, double body_motion, double comfort_offset) {
  if (schedule.poses < 2) return {};
  const double max_motion = std::max(kMinOffset, comfort_offset);
  if (body_motion > kMaxParts * max_motion)
    throw InputError(joined("the body moves ", body_motion, " m in a time step of ", schedule.time_step,
                            " s: expected at most ", kMaxParts * max_motion,
                            " m: raise seconds_per_pose or steps in [body], or steps_per_pose in [solver]"));
  Substeps parts;
  parts.interpolation =
      std::max(1, static_cast<int>(std::ceil(body_motion * schedule.steps_per_pose / kMaxMotionPerLevelSet)));
  // Each part of an interpolation step takes a whole number of parts of time steps.
  const int multiple = parts.interpolation / std::gcd(parts.interpolation, schedule.steps_per_pose);
  parts.time = multiple * std::max(1, static_cast<int>(std::ceil(body_motion / max_motion / multiple)));
  return parts;
}

}  // namespace ease
