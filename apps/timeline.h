// The moments of a run: where the body is at the end of each time step, and what is due then.
//
//   s   how far the body's motion is, in interpolation steps (moving_body.h)
#pragma once

#include <vector>

#include "apps/scene.h"

namespace ease {

struct Moment {
  int step;  // 1, 2, ...
  double time_s;
  double body;                     // s
  int next_level_set;              // to be prepared while this step is computed, since the next one needs it; -1: none
  int pose;                        // reached now; -1: none
  bool adapts, measured, written;  // what is written or adapted has been measured
};

/// `adapting`: the run that adapts, with its cycles and its settling; otherwise once through the motion.
std::vector<Moment> timeline(const Scene& scene, bool adapting);

/// Into how many parts each time step is divided so that contact can follow the body: its surface near the garment
/// moves by at most half the comfort offset (or 2.5 mm where that is less than 5 mm) in a part.
int substepsFor(const Scene& scene, const SceneInput& input);

/// The scene with every time step divided into so many; what is counted in time steps is counted in parts.
Scene divided(const Scene& scene, int substeps);

}  // namespace ease
