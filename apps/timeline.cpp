#include "apps/timeline.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/mesh/error.h"

namespace ease {

namespace {

constexpr double kNear = 0.05;  // m: of the garment's box, where the body's motion matters
constexpr int kFramesACheckpoint = 10;
constexpr int kMostParts = 256;             // of a time step
constexpr double kMostMotionOfPose = 0.03;  // m, in an interpolation step

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
    Moment m{step, step * scene.solver.time_step, bodyAt(step), -1, -1, false, false, false, false};
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
    const bool tenth_frame = scene.output && step % (kFramesACheckpoint * scene.output->every) == 0;
    m.kept = adapting && (tenth_frame || m.pose >= 0 || step == count);
    moments.push_back(m);
  }
  return moments;
}

double bodyMotionOfStep(const Scene& scene, const SceneInput& input) {
  if (input.poses.size() < 2) return 0.0;
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
  return furthest / (scene.body->steps * scene.solver.steps_per_pose);
}

Division divisionFor(const Scene& scene, const SceneInput& input) {
  if (input.poses.size() < 2) return {};
  const double motion = bodyMotionOfStep(scene, input), least = 0.5 * std::max(0.005, scene.collision.offset);
  if (motion > kMostParts * least)
    throw InputError(
        fmt::format("{}: [body] steps = {}: the body moves {:.3g} m in a time step of {:g} s: expected at "
                    "most {:.2g} m; more interpolation steps, or more time steps for each?",
                    scene.file.string(), scene.body->steps, motion, scene.solver.time_step, kMostParts * least));
  const int per_pose = scene.solver.steps_per_pose;
  Division division;
  division.interpolation_steps = std::max(1, static_cast<int>(std::ceil(motion * per_pose / kMostMotionOfPose)));
  // Whole time steps between the poses.
  const int multiple = division.interpolation_steps / std::gcd(division.interpolation_steps, per_pose);
  division.time_steps = multiple * std::max(1, static_cast<int>(std::ceil(motion / least / multiple)));
  return division;
}

Scene divided(const Scene& scene, const Division& division) {
  const int parts = division.time_steps;
  Scene fine = scene;
  fine.solver.time_step /= parts;
  fine.solver.steps_per_pose = scene.solver.steps_per_pose * parts / division.interpolation_steps;
  if (fine.body) fine.body->steps *= division.interpolation_steps;
  fine.solver.steps *= parts;
  if (fine.adaption) fine.adaption->every *= parts, fine.adaption->settle *= parts;
  if (fine.output) fine.output->every *= parts;
  return fine;
}

}  // namespace ease
