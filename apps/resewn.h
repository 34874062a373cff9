// The proof of a pattern: the garment sewn from its flat pieces is simulated as the one that was designed, and both are
// compared.
//
// Sewing is a change of the rest shape alone: the garment's triangles stay joined, their flat edges become those of the
// pieces on the paper.  Each of the two rest shapes is held on the first pose, from the same start, then carried
// through the whole motion.
//
// Where the sewn garment is over the limit and the designed one is not, pieces are let out on the paper: the flat
// triangles grow as the motion asks for (adaption/growth_demand.h), are flattened again, and checked again.  Only these
// triangles and those around them may become larger nearly without cost (flattening.h), so that the rest of the pieces
// stays as it is.
#pragma once

#include <atomic>

#include "apps/scene.h"
#include "garment/pattern/flat_pattern.h"
#include "solver/model/rest_shape.h"

namespace ease {

/// How far the sewn garment lies from the designed one in one pose.
struct ResewnPose {
  std::string pose;
  double rms_m = 0.0, max_m = 0.0;  // distance of the vertices of both garments
};

struct ResewnSeam {
  std::string name;
  double rms_m = 0.0;  // distance of its vertices at the worst pose
};

struct Resewn {
  ResewnPose own;                 // held on the first pose
  std::vector<ResewnPose> poses;  // in the motion
  std::vector<ResewnSeam> seams;
  double designed_over_limit = 0.0, over_limit = 0.0;  // share of the triangles at the worst moment
  int rounds = 0;                                      // of letting out on the paper
  double area_ratio = 1.0;                             // cloth of the pieces over that of the first ones
  bool has_limit = false;
  double wall_s = 0.0;
  Positions designed_end, sewn_end;  // at the end of the motion, m, in the order of the garment's file
};

/// Simulates both garments.  Lets pieces out in at most `scene.pattern.let_out` rounds, until the sewn garment is over
/// the limit no more than the designed one; `pattern` becomes the best pattern found.  `designed`: rest shape of the
/// run. Throws Interrupted, and ComputationError as a run does.
Resewn sewAgain(const Scene& scene, const SceneInput& input, const RestShape& designed, const FlatSettings& settings,
                const std::atomic<bool>& interrupted, FlatPattern& pattern);

}  // namespace ease
