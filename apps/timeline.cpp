#include "apps/timeline.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/base/error.h"

namespace ease {

namespace {

constexpr double kNear = 0.05;  // m: of the garment's box, where the body's motion matters
constexpr int kFramesACheckpoint = 10;
constexpr int kMostParts = 256;             // of a time step
constexpr double kMostMotionOfPose = 0.03;  // m, in an interpolation step

}  // namespace

std::vector<int> posesOfMotion(const Scene& scene, bool adapting) {
  if (!scene.body) return {};
  const int poses = static_cast<int>(scene.body->poses.size()), legs = poses - 1;
  std::vector<int> order = {0};
  for (int leg = 1; leg <= legs * (adapting && scene.adaption ? scene.adaption->cycles : 1); ++leg) {
    const int there_and_back = leg % (2 * legs);
    order.push_back(there_and_back < poses ? there_and_back : 2 * legs - there_and_back);
  }
  return order;
}

std::vector<Moment> timeline(const Scene& scene, bool adapting, const StepsDone& done) {
  const int per_pose = scene.solver.steps_per_pose;
  const int steps_between = scene.body ? scene.body->steps : 0;
  const bool adapts = adapting && scene.adaption, moves = scene.body && scene.body->poses.size() > 1;
  const std::vector<int> poses = posesOfMotion(scene, adapting);
  const int motion = timeStepsOfMotion(scene) * (adapts ? scene.adaption->cycles : 1);
  const int moving = moves ? motion : 0, held = motion - moving, still = held + (adapts ? scene.adaption->settle : 0);

  StepsDone now = done;
  const int left = std::max(0, moving - done.moving);
  if (left > 0) now.still = 0;
  const int count = left + std::max(0, still - now.still);
  std::vector<Moment> moments;
  for (int k = 1; k <= count; ++k) {
    ++now.all;
    ++(k <= left ? now.moving : now.still);
    const auto bodyAt = [&](int step) { return step / static_cast<double>(per_pose); };
    Moment m{now,  now.all * scene.solver.time_step, bodyAt(now.moving), -1, -1, now.still > held, false, false, false,
             false};
    const long next = std::lround(bodyAt(now.moving + (k < left ? 1 : 0)));
    if (next != std::lround(m.body)) m.next_level_set = static_cast<int>(next);
    const int leg = per_pose * steps_between;
    if (k <= left && now.moving % leg == 0) m.pose = poses[now.moving / leg];
    const int every = scene.adaption ? scene.adaption->every : scene.output ? scene.output->every : 8;
    m.adapts = adapts && now.all % every == 0;
    m.written = adapting && scene.output && (now.all % scene.output->every == 0 || k == count);
    m.measured = m.written || m.adapts || m.pose >= 0 || now.all % every == 0 || k == count;
    const bool tenth_frame = scene.output && now.all % (kFramesACheckpoint * scene.output->every) == 0;
    m.kept = adapting && (tenth_frame || m.pose >= 0 || k == count);
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
