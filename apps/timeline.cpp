#include "apps/timeline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ease {

namespace {

constexpr double kNear = 0.05;  // m: of the garment's box, where the body's motion matters
constexpr int kMostSubsteps = 64;

}  // namespace

std::vector<Moment> timeline(const Scene& scene, bool adapting) {
  const int per_pose = scene.solver.steps_per_pose;
  const int poses = scene.body ? static_cast<int>(scene.body->poses.size()) : 0;
  const int steps_between = scene.body ? scene.body->steps : 0;
  const bool adapts = adapting && scene.adaption;
  const int motion = timeStepsOfMotion(scene) * (adapts ? scene.adaption->cycles : 1);
  const int count = motion + (adapts ? scene.adaption->settle : 0);
  const auto bodyAt = [&](int step) {
    return poses > 1 ? std::min(step, motion) / static_cast<double>(per_pose) : 0.0;
  };

  std::vector<Moment> moments;
  for (int step = 1; step <= count; ++step) {
    Moment m{step, step * scene.solver.time_step, bodyAt(step), -1, -1, false, false, false};
    const long next = std::lround(bodyAt(step + 1));
    if (poses > 1 && next != std::lround(m.body)) m.next_level_set = static_cast<int>(next);
    if (poses > 1 && step <= motion && step % (per_pose * steps_between) == 0) {
      const int leg = step / (per_pose * steps_between) % (2 * (poses - 1));  // there and back again
      m.pose = leg < poses ? leg : 2 * (poses - 1) - leg;
    }
    const int every = scene.adaption ? scene.adaption->every : scene.output ? scene.output->every : 8;
    m.adapts = adapts && step % every == 0;
    m.written = adapting && scene.output && (step % scene.output->every == 0 || step == count);
    m.measured = m.written || m.adapts || m.pose >= 0 || step % every == 0 || step == count;
    moments.push_back(m);
  }
  return moments;
}

int substepsFor(const Scene& scene, const SceneInput& input) {
  if (input.poses.size() < 2) return 1;
  const Positions& first = input.poses.front();
  Eigen::AlignedBox3d reach;
  for (int i = 0; i < input.garment.positions.rows(); ++i) reach.extend(input.garment.positions.row(i).transpose());
  reach.min().array() -= kNear;
  reach.max().array() += kNear;
  double furthest = 0.0;  // from a pose to the next
  for (size_t p = 0; p + 1 < input.poses.size(); ++p)
    for (int i = 0; i < first.rows(); ++i)
      if (reach.contains(Vec3(first.row(i))))
        furthest = std::max(furthest, (input.poses[p + 1].row(i) - input.poses[p].row(i)).norm());
  const double a_step = furthest / (scene.body->steps * scene.solver.steps_per_pose);
  const double least = 0.5 * std::max(0.005, scene.collision.offset);
  return std::clamp(static_cast<int>(std::ceil(a_step / least)), 1, kMostSubsteps);
}

Scene divided(const Scene& scene, int substeps) {
  Scene fine = scene;
  fine.solver.time_step /= substeps;
  fine.solver.steps_per_pose *= substeps;
  fine.solver.steps *= substeps;
  if (fine.adaption) fine.adaption->every *= substeps, fine.adaption->settle *= substeps;
  if (fine.output) fine.output->every *= substeps;
  return fine;
}

}  // namespace ease
