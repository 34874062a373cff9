// The moments of a run: where the body is at the end of each time step, and what is due then.
//
//   s   how far the body's motion is, in interpolation steps (moving_body.h)
#pragma once

#include <vector>

#include "apps/scene.h"

namespace ease {

/// How far a run is, in time steps.
struct StepsDone {
  int all = 0;
  int moving = 0;  // of these, those in which the body moved: its place on its way
  int still = 0;   // since it moved last
};

struct Moment {
  StepsDone done;  // with this step
  double time_s;
  double body;                     // s
  int next_level_set;              // to be prepared while this step is computed, since the next one needs it; -1: none
  int pose;                        // reached now; -1: none
  bool settles;                    // after the motion
  bool adapts, measured, written;  // what is written or adapted has been measured
  bool kept;                       // as a checkpoint, from which a later run can go on
};

/// Numbers of the body's poses in the order of its motion, forth and back.  `adapting`: the run that adapts, with its
/// cycles and its settling; otherwise once through the motion.
std::vector<int> posesOfMotion(const Scene& scene, bool adapting);

/// What is left to do.  The body goes on from where it is on its way; where that was the end of a shorter motion, on
/// which it stood already, it stands anew at the end of this one.
std::vector<Moment> timeline(const Scene& scene, bool adapting, const StepsDone& done = {});

/// How far the body's surface near the garment moves in a time step, at most, m.
double bodyMotionOfStep(const Scene& scene, const SceneInput& input);

/// Into how many parts steps are divided where the body moves far in one.
struct Division {
  int time_steps = 1;           // parts of a time step, so that contact can follow the body
  int interpolation_steps = 1;  // parts of an interpolation step, so that a level set's band reaches to the next
};

/// The body's surface near the garment moves by at most half the comfort offset (or 2.5 mm where that is less than
/// 5 mm) in a part of a time step, and by 3 cm in a part of an interpolation step.  Throws InputError where a time step
/// would have more than 256 parts.
Division divisionFor(const Scene& scene, const SceneInput& input);

/// The scene with its steps divided; what is counted in steps is counted in parts.
Scene divided(const Scene& scene, const Division& division);

}  // namespace ease
