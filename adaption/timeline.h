// The clock of a run: which time steps there are, where the body is after each of them, and what is due then.
//
// The body moves from pose to pose and back again.  Between two poses lie `interpolation_steps` shapes of the body, and
// from each of them to the next the cloth takes `steps_per_pose` time steps.
#pragma once

#include <vector>

namespace ease {

/// What decides how long a run takes and what is done on the way.
struct Schedule {
  double time_step = 0.0025;     // s
  int poses = 0;                 // of the body; 0: there is no body
  int interpolation_steps = 60;  // from a pose to the next; with a single pose, how long it is held
  int steps_per_pose = 4;        // time steps for each interpolation step (not for each of the `poses`)
  int steps_without_body = 0;    // time steps of a run without a body
  int cycles = 1;                // times through the motion: to the last pose, back, to the last pose, ...
  int settle = 0;                // time steps after the end of the motion
  int adapt_every = 0;           // time steps; 0: the rest shape stays
  int measure_every = 8;         // time steps
  int write_every = 0;           // time steps for each written frame; 0: nothing is written
};

/// How far a run is, in time steps.
struct StepsDone {
  int total = 0;   // of the run
  int moving = 0;  // those in which the body moved; they determine where the body is
  int still = 0;   // since the body moved last
};

/// The end of a time step.
struct Moment {
  StepsDone done;           // includes this step
  double time_s = 0.0;      // since the start
  bool moves = false;       // the body moves in this step
  bool settles = false;     // the motion was over before this step
  int pose = -1;            // pose that the body has reached; -1: none
  bool adapts = false;      // the rest shape is adapted
  bool measured = false;    // stretch and distance to the body are measured; true wherever it adapts or writes
  bool written = false;     // a frame is written
  bool last = false;        // of the run
  bool shown = false;       // measured, and worth a picture: a pose, the end, and a few dozen between
  bool checkpoint = false;  // a later run may go on from here
};

/// Numbers of the poses in the order in which the body reaches them.  Empty without a body.
std::vector<int> posesOfMotion(const Schedule& schedule);

/// Number of time steps that one passage from the first pose to the last takes.
int timeStepsOfMotion(const Schedule& schedule);

/// The time steps that are left after those that are done.  Where poses were added to the schedule since, the body goes
/// on from where it stands, and time that it has spent standing there does not count at the new end.
std::vector<Moment> timeline(const Schedule& schedule, const StepsDone& done = {});

/// The moment before the first time step.
Moment startMoment(const Schedule& schedule);

}  // namespace ease
