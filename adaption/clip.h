// Clipping of principal stretches: how much each rest triangle must grow so that its cloth is comfortable.
//
//   F = U diag(sigma_i) Vᵀ asks for rest edges D' = G D,   G = V diag(clamp(sigma_i / goal, 1, 1.02)) Vᵀ
//                          where sigma_1 is above a threshold; goal and threshold lie below 1 + limit
//
// after Wolff et al. 2022.  Compression is always allowed.
//
// Clipping alone acts like plastic yielding without hardening, which necks: tension is the same all along a loop around
// the body, so that the triangle that yields first relieves all others and yields again the next time.  Three rules
// spread the growth:
//   - cloth that has already grown may come nearer to the limit than cloth that has not (hardening);
//   - a triangle grows by at most 2 % at a time, which leaves a share of the growth to the others;
//   - growth is averaged over adjacent triangles, whose tensors are comparable since all use the material's frame.
// Cloth that hangs by its own weight, or is pinned apart, stays stretched however much it grows: it may grow to
// kMaxGrowth (growth.h) times its first length and no further.
//
// Shirt of 3,032 vertices, T to A to arms up, 5 times: largest growth 1.8 where it was above 3.
#pragma once

#include <vector>

#include "adaption/growth.h"

namespace ease {

class StretchClip {
 public:
  /// `limit`: largest comfortable strain, delta > 0.
  explicit StretchClip(double limit) : limit_(limit) {}

  /// Computes the growth tensor G of each triangle from the cloth's present stretches; returns false if none grows.
  bool clip(const Cloth& cloth, const std::vector<Stretch>& stretch, std::vector<Mat2>& growth);

  /// Number of triangles that the last clip() found stretched beyond the limit although they have grown as much as
  /// adaption allows.
  int fullyGrown() const { return fully_grown_; }

 private:
  double limit_;
  int fully_grown_ = 0;
};

/// The stretch above which a triangle grows and the stretch that it grows to, after it has grown to `growth` times its
/// first length in that direction.  Both are below 1 + limit, so that the limit also holds between adaptions.
struct StretchGoal {
  double act_above, grow_to;
};
StretchGoal stretchGoal(double limit, double growth);

}  // namespace ease
