#include "adaption/timeline.h"

#include <algorithm>

namespace ease {

namespace {

constexpr int kFramesPerCheckpoint = 10;
constexpr int kShownMoments = 24;  // of a whole run, and every pose

bool bodyMoves(const Schedule& schedule) {
  return schedule.poses > 1;
}

bool isEvery(int count, int interval) {
  return interval > 0 && count % interval == 0;
}

/// Fills in what is due at the end of a step.
void setDue(const Schedule& schedule, bool is_last, Moment& moment) {
  const int step = moment.done.total;
  moment.last = is_last;
  moment.adapts = isEvery(step, schedule.adapt_every);
  moment.written = schedule.write_every > 0 && (isEvery(step, schedule.write_every) || is_last);
  const bool has_reached_pose = moment.pose >= 0;
  moment.measured =
      moment.written || moment.adapts || has_reached_pose || isEvery(step, schedule.measure_every) || is_last;
  moment.checkpoint = has_reached_pose || isEvery(step, kFramesPerCheckpoint * schedule.write_every) || is_last;
}

}  // namespace

std::vector<int> posesOfMotion(const Schedule& schedule) {
  if (schedule.poses == 0) return {};
  const int legs = schedule.poses - 1;
  std::vector<int> order = {0};
  for (int leg = 1; leg <= legs * schedule.cycles; ++leg) {
    const int there_and_back = leg % (2 * legs);
    order.push_back(there_and_back < schedule.poses ? there_and_back : 2 * legs - there_and_back);
  }
  return order;
}

int timeStepsOfMotion(const Schedule& schedule) {
  if (schedule.poses == 0) return schedule.steps_without_body;
  return std::max(1, schedule.poses - 1) * schedule.interpolation_steps * schedule.steps_per_pose;
}

std::vector<Moment> timeline(const Schedule& schedule, const StepsDone& done) {
  const int motion = timeStepsOfMotion(schedule) * schedule.cycles;
  const int moving = bodyMoves(schedule) ? motion : 0;
  const int held = motion - moving;  // steps of a body that only stands, or of none
  const int moving_left = std::max(0, moving - done.moving);
  StepsDone now = done;
  if (moving_left > 0) now.still = 0;
  const int count = moving_left + std::max(0, held + schedule.settle - now.still);

  const std::vector<int> poses = posesOfMotion(schedule);
  const int steps_per_leg = schedule.steps_per_pose * schedule.interpolation_steps;
  const int total = now.total + count;
  int shown = static_cast<int>(static_cast<long>(now.total) * kShownMoments / std::max(1, total));
  std::vector<Moment> moments;
  for (int k = 1; k <= count; ++k) {
    Moment moment;
    moment.moves = k <= moving_left;
    ++now.total;
    ++(moment.moves ? now.moving : now.still);
    moment.done = now;
    moment.time_s = now.total * schedule.time_step;
    moment.settles = now.still > held;
    if (moment.moves && now.moving % steps_per_leg == 0) moment.pose = poses[now.moving / steps_per_leg];
    setDue(schedule, k == count, moment);
    const int due = static_cast<int>(static_cast<long>(now.total) * kShownMoments / total);
    moment.shown = moment.measured && (moment.pose >= 0 || k == count || due > shown);
    if (moment.shown) shown = due;
    moments.push_back(moment);
  }
  return moments;
}

Moment startMoment(const Schedule& schedule) {
  Moment start;
  start.pose = schedule.poses > 0 ? 0 : -1;
  start.measured = start.shown = start.checkpoint = true;
  start.written = schedule.write_every > 0;
  return start;
}

}  // namespace ease
