// What the page of a run shows of one motion: the garment at the moments worth a picture, and curves over all measured
// moments.
#pragma once

#include <optional>
#include <vector>

#include "adaption/run_watch.h"
#include "apps/scene.h"

namespace ease {

/// The garment and the body at one moment, in the numbering of the scene's garment.
struct ShownMoment {
  double time_s = 0.0;
  int pose = -1;                // that the body has reached; -1: none
  Positions garment, body;      // m; the body is empty without one
  std::vector<float> sigma_1;   // of every triangle, larger principal stretch; NaN where it is crumpled
  std::vector<float> over;      // of every triangle: 1 over the limit, 0 within
  std::vector<float> pressure;  // of the body on every vertex, Pa; empty without a body and before the first step
  std::vector<float> distance;  // of every vertex to the body, m; empty without a body
};

struct MotionAlbum {
  std::vector<ShownMoment> moments;   // in the order of time
  std::vector<MeasuredMoment> curve;  // in the order of time
  std::vector<double> wall_s;         // since the start, for each measured moment
};

/// Lets the album, emptied, be filled by the run.  `given`: the scene's input in the numbering of its files;
/// `numbering`: the run's.  `poses_only`: leaves out what lies between poses.  All must outlive the run.
void fillAlbum(RunWatch& watch, const SceneInput& given, const InputNumbering& numbering, std::optional<double> limit,
               bool poses_only, MotionAlbum& album);

/// The last moment at which the body was in this pose; null where it was never there.
const ShownMoment* momentOfPose(const MotionAlbum& album, int pose);

}  // namespace ease
