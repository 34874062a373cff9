// Clipping of principal stretches: how much each rest triangle must grow so that its cloth is comfortable.
//
//   F = U diag(sigma_i) Vᵀ, clipped to U diag(min(sigma_i, 1 + limit)) Vᵀ, asks for rest edges
//   D' = G D,   G = V diag(max(1, sigma_i / (1 + limit))) Vᵀ     2x2, symmetric, >= 1
//
// after Wolff et al. 2022.  Compression is always allowed.
//
// Clipping alone is yielding without hardening, and necks like it: tension is the same all along a loop around the
// body, so that the triangle that yields first relieves all others and is the one that yields the next time too.  Three
// things spread the growth:
//   - cloth that has grown already is let nearer to the limit than cloth that has not (hardening);
//   - a triangle grows by a little at a time, so that the others have their share of what is left;
//   - growth is smoothed over neighbours, whose tensors are comparable since all share the material's frame.
// Cloth that hangs by its own weight, or is pinned apart, stays stretched however much it grows: it is let grow
// kMostGrowth times its first length and no further.
//
// Shirt of 3,032 vertices, T to A to arms up, 5 times: largest growth 1.8 where it was above 3.
#pragma once

#include <vector>

#include "adaption/stretch_measure.h"

namespace ease {

/// Times its first length, that adaption lets cloth grow to: a body asks for less.
constexpr double kMostGrowth = 3.0;

class StretchClip {
 public:
  /// Growth counts from the cloth's present rest shape.  `limit`: delta, > 0.
  StretchClip(const Cloth& cloth, double limit);

  /// Growth tensor of every triangle for the cloth's present stretches; returns false where none grows.
  bool clip(const Cloth& cloth, const std::vector<Stretch>& stretch, std::vector<Mat2>& growth);

  /// Triangles, at the last clip(), that are stretched beyond the limit and have grown as much as they may.
  int fullyGrown() const { return fully_grown_; }

 private:
  std::vector<Mat2> first_edges_;
  double limit_;
  int fully_grown_ = 0;
};

/// Stretch above which cloth grows that has grown `growth` times in that direction so far, and the stretch that it then
/// grows to: below 1 + limit, so that it is kept between adaptions too.
struct StretchGoal {
  double act_above, grow_to;
};
StretchGoal stretchGoal(double limit, double growth);

}  // namespace ease
