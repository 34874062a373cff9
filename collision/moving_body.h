// The body in motion: interpolates between its poses and keeps the level sets of the poses around the present one.
//
//   s     position along the motion, in interpolation steps: pose p is reached at s = p * steps; beyond the last pose
//         the motion runs back to the first, and forth again
//   k     number of an interpolated pose, at s = k
//   L_k   level set of interpolated pose k; serves all s whose nearest whole number is k
//
// If a pose returns, in another pass or as the motion runs back, its level set starts from the corners that were
// computed before; 400 MB of them are kept for all poses.  No distance changes, since it depends on pose and corner.
//
// prepare(k + 1) writes nothing that a user of L_k reads, so that both may run at the same time.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "collision/body/pose_interpolation.h"
#include "collision/contacts.h"
#include "collision/known_corners.h"

namespace ease {

class MovingBody {
 public:
  /// `steps`: interpolation steps from a pose to the next.  With one pose the body does not move.  `way`: through these
  /// poses; null: it is computed.
  MovingBody(const Triangles& triangles, const std::vector<Positions>& poses, int steps, const LevelSetOptions& options,
             std::shared_ptr<const InterpolatedPoses> way = nullptr);

  const Triangles& triangles() const { return triangles_; }
  /// Distances to the body are exact below this, m.
  double band() const { return band_; }
  /// Interpolation steps from the first pose to the last.
  int motionSteps() const { return static_cast<int>(way_->interpolations.size()) * steps_; }

  /// Makes the poses k - 1, k and k + 1, and L_k around the points.  Call with k = 0, 1, 2, ... or start over at 0.
  void prepare(int k, std::span<const Vec3> points);

  /// The body at s.  prepare() must have been called for the pose nearest to s.
  BodyMoment at(double s);

  /// Computes the positions of the vertices at s, m.  prepare() must have been called for the pose nearest to s.
  void positions(double s, Positions& x) const;

  struct Times {
    double interpolation_s = 0.0, level_set_s = 0.0;  // wall time of the thread that called prepare()
  };
  const Times& times() const { return times_; }
  size_t levelSetBytes() const;
  /// Number of voxel corners, over all level sets so far, that prepare() did not foresee.
  long voxelsOnDemand() const;

 private:
  /// Number of the pose between the first and the last one that pose k repeats, as the motion runs back and forth.
  int folded(int k) const;
  /// Computes pose k unless its slot holds it already.
  void interpolate(int k);
  const Positions& pose(int k) const;
  /// The body at s without level set and tree.
  BodyMoment motionAt(double s) const;

  struct Slot {
    int k = -1;
    Positions positions;
  };
  struct Prepared {
    TriangleTree tree;
    LevelSet level_set;
    int k = -1;  // folded; -1: not prepared yet
  };
  /// Remembers the corners of a level set that is going to be replaced.
  void remember(const Prepared& prepared);

  Triangles triangles_;
  int steps_;
  double margin_;  // m
  double band_;    // m
  Positions first_;
  std::shared_ptr<const InterpolatedPoses> way_;
  std::array<Slot, 4> poses_;        // pose k in slot k mod 4
  std::vector<Prepared> prepared_;   // L_k in place k mod 2
  std::vector<KnownCorners> known_;  // by folded pose
  size_t known_bytes_ = 0;
  Times times_;
  long voxels_on_demand_ = 0;  // of level sets that have been replaced
};

}  // namespace ease
