#include "adaption/timeline.h"

#include <catch2/catch.hpp>
#include <tuple>

using namespace ease;

namespace {

/// From the first pose to the second in 40 time steps, adapted and written.
Schedule twoPoses() {
  Schedule schedule;
  schedule.poses = 2;
  schedule.interpolation_steps = 10;
  schedule.steps_per_pose = 4;
  schedule.adapt_every = schedule.measure_every = schedule.write_every = 8;
  return schedule;
}

auto membersOf(const Moment& m) {
  return std::tie(m.done.total, m.done.moving, m.done.still, m.time_s, m.moves, m.pose, m.settles, m.adapts, m.written,
                  m.measured);
}

}  // namespace

TEST_CASE("pictures are due at poses, at the end, and at a couple of dozen measured moments between") {
  Schedule schedule = twoPoses();
  schedule.interpolation_steps = 100;
  schedule.settle = 5;
  const std::vector<Moment> moments = timeline(schedule);
  int shown = 0;
  for (const Moment& m : moments) {
    CHECK(m.last == (m.done.total == 405));
    if (m.last || m.pose >= 0) CHECK(m.shown);
    if (m.shown) CHECK(m.measured);
    shown += m.shown;
  }
  CHECK(shown >= 24);
  CHECK(shown <= 27);
  CHECK(startMoment(schedule).shown);
}

TEST_CASE("what is due comes at its interval, at poses and at the end") {
  Schedule schedule = twoPoses();
  schedule.settle = 3;
  schedule.write_every = 5;
  const std::vector<Moment> moments = timeline(schedule);
  REQUIRE(moments.size() == 43);
  for (const Moment& m : moments) {
    CHECK(m.time_s == Approx(0.0025 * m.done.total));
    CHECK(m.adapts == (m.done.total % 8 == 0));
    CHECK(m.written == (m.done.total % 5 == 0 || m.done.total == 43));
    CHECK(m.pose == (m.done.total == 40 ? 1 : -1));
    CHECK(m.measured == (m.adapts || m.written || m.pose >= 0));
    CHECK(m.checkpoint == (m.done.total >= 40 && m.done.total != 41 && m.done.total != 42));
    CHECK(m.moves == (m.done.total <= 40));
    CHECK(m.settles == (m.done.total > 40));
  }
  schedule.write_every = schedule.adapt_every = 0;
  for (const Moment& m : timeline(schedule)) CHECK_FALSE((m.written || m.adapts));
}

TEST_CASE("a checkpoint comes every tenth frame") {
  Schedule schedule = twoPoses();
  schedule.write_every = 2;
  for (const Moment& m : timeline(schedule)) CHECK(m.checkpoint == (m.done.total % 20 == 0));
}

TEST_CASE("the start is measured and stands on the first pose, if there is one") {
  CHECK(startMoment(twoPoses()).pose == 0);
  CHECK(startMoment(twoPoses()).measured);
  CHECK(startMoment(twoPoses()).written);
  CHECK(startMoment(Schedule()).pose == -1);
  CHECK_FALSE(startMoment(Schedule()).written);
}

TEST_CASE("a run that goes on does what is left, and none of it is the motion that is done") {
  Schedule schedule = twoPoses();
  schedule.settle = 6;
  const std::vector<Moment> whole = timeline(schedule);
  REQUIRE(whole.size() == 46);
  CHECK(whole[39].pose == 1);
  CHECK_FALSE(whole[39].settles);
  CHECK(whole[40].settles);
  for (const size_t done : {7, 40, 43}) {
    const std::vector<Moment> left = timeline(schedule, whole[done - 1].done);
    REQUIRE(left.size() == 46 - done);
    for (size_t k = 0; k < left.size(); ++k) CHECK(membersOf(left[k]) == membersOf(whole[done + k]));
  }
  CHECK(timeline(schedule, whole.back().done).empty());
}

TEST_CASE("a body that stood at its last pose goes on from there to one that was added, and stands there anew") {
  Schedule schedule = twoPoses();
  schedule.settle = 6;
  const StepsDone done = timeline(schedule).back().done;
  const auto goesOn = [&] {
    const std::vector<Moment> left = timeline(schedule, done);
    REQUIRE(left.size() == 46);
    CHECK(left.front().done.total == 47);
    CHECK(left.front().done.moving == 41);
    CHECK(left[39].done.moving == 80);
    CHECK(left.back().done.moving == 80);
    return left[39].pose;
  };
  schedule.poses = 3;
  CHECK(goesOn() == 2);
  schedule.poses = 2;
  schedule.cycles = 2;
  CHECK(goesOn() == 0);
  schedule.cycles = 1;
  schedule.settle = 8;
  CHECK(timeline(schedule, done).size() == 2);
}

TEST_CASE("a body of one pose, or none, has no motion, and steps are left until it was held long enough") {
  Schedule schedule = twoPoses();
  schedule.poses = 1;
  CHECK(posesOfMotion(schedule) == std::vector<int>{0});
  CHECK(timeline(schedule).size() == 40);
  CHECK(timeline(schedule, {13, 0, 13}).size() == 27);
  CHECK(timeline(schedule, {13, 0, 13}).back().done.moving == 0);
  schedule.poses = 0;
  schedule.steps_without_body = 30;
  CHECK(posesOfMotion(schedule).empty());
  CHECK(timeline(schedule, {13, 0, 13}).size() == 17);
}

TEST_CASE("poses come there and back again") {
  Schedule schedule = twoPoses();
  schedule.poses = 3;
  schedule.cycles = 3;
  CHECK(posesOfMotion(schedule) == std::vector<int>{0, 1, 2, 1, 0, 1, 2});
  schedule.cycles = 1;
  CHECK(posesOfMotion(schedule) == std::vector<int>{0, 1, 2});
}
