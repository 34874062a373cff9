// Clipping of principal stretches: how much each rest triangle must grow so that its cloth is comfortable.
//
//   F = U diag(sigma_i) Vᵀ, clipped to U diag(min(sigma_i, 1 + limit)) Vᵀ, asks for rest edges
//   D' = G D,   G = V diag(max(1, sigma_i / (1 + limit))) Vᵀ     2x2, symmetric, >= 1
//
// after Wolff et al. 2022.  Compression is always allowed.  Clipping alone is yielding without hardening: one row of
// triangles grows on while its neighbours do not.  Growth is therefore smoothed over neighbours, whose tensors are
// comparable since all triangles share the material's frame.
#pragma once

#include <vector>

#include "adaption/stretch_measure.h"

namespace ease {

struct ClipOptions {
  double act_above;  // stretch above 1 + this grows: below the limit, so that it is kept between adaptions
  double grow_to;    // ... until it is 1 + this
  int smoothing;     // passes over neighbours
};

/// Options for a limit delta.
ClipOptions clipOptions(double limit);

/// Growth tensor of every triangle; returns false where none grows.
bool clipStretch(const Cloth& cloth, const std::vector<Stretch>& stretch, const ClipOptions& options,
                 std::vector<Mat2>& growth);

}  // namespace ease
