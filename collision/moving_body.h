// The body in motion: interpolated poses, and the level set of each.
//
//   s     how far the motion is, in interpolation steps: pose p is reached at s = p * steps; beyond the last pose the
//         motion runs back, and forth again
//   L_k   level set of interpolated pose k; stands for the body while s is nearest to k
//
// prepare(k + 1) touches nothing that L_k's users read, so that it may run beside them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "collision/body/pose_interpolation.h"
#include "collision/contacts.h"

namespace ease {

class MovingBody {
 public:
  /// `steps`: interpolation steps from a pose to the next.  One pose: a body that does not move.
  MovingBody(const Triangles& triangles, const std::vector<Positions>& poses, int steps,
             const LevelSetOptions& options);

  const Triangles& triangles() const { return triangles_; }
  /// Interpolation steps from the first pose to the last.
  int motionSteps() const { return static_cast<int>(interpolations_.size()) * steps_; }

  /// Makes L_k, right around the points, and the poses k - 1, k, k + 1.  Call with k = 0, 1, 2, ... or start over at 0.
  void prepare(int k, std::span<const Vec3> points);

  /// Level set and motion around s; the level set of the pose nearest to s must have been prepared.
  BodyMoment at(double s);

  /// Vertices at s, m.
  void positions(double s, Positions& x) const;

  struct Times {
    double interpolation_s = 0.0, level_set_s = 0.0;  // wall, of the thread that prepared
  };
  const Times& times() const { return times_; }
  size_t levelSetBytes() const;
  /// Voxels, of all level sets so far, that prepare() did not foresee.
  long voxelsOnDemand() const;

 private:
  int folded(int k) const;
  void interpolate(int k);
  const Positions& pose(int k) const;

  struct Slot {
    int k = -1;
    Positions positions;
  };
  struct Prepared {
    TriangleTree tree;
    LevelSet level_set;
  };

  Triangles triangles_;
  int steps_;
  double margin_;  // m
  Positions first_;
  std::vector<PoseInterpolation> interpolations_;
  std::array<Slot, 4> poses_;       // pose k in slot k mod 4
  std::vector<Prepared> prepared_;  // L_k in k mod 2
  Times times_;
  long voxels_on_demand_ = 0;  // of level sets replaced since
};

}  // namespace ease
