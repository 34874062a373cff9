// Growth of rest triangles as symmetric 2x2 tensors in the material's plane.
//
//   G     symmetric, >= 1: a triangle with flat rest edges D is to have the edges G D
//   G²    the metric of the grown triangle, measured on the present one
//
// The tensors of different triangles may be averaged, because all use the material's frame (rows: warp, weft).
#pragma once

#include <vector>

#include "adaption/stretch_measure.h"

namespace ease {

/// Upper bound of growth: length over first length.  Fitting a body needs less; cloth that a load stretches would grow
/// for ever.
constexpr double kMaxGrowth = 3.0;

/// The tensor that scales by `along` in the direction `direction` (unit) and by `across` perpendicular to it.
Mat2 growthTensor(double along, double across, const Eigen::Vector2d& direction);

/// The smallest growth that is at least as large as both in every direction.
Mat2 smallestAboveBoth(const Mat2& a, const Mat2& b);

/// How much longer the triangle's rest shape is than its first one, in a direction of the material's plane (unit).
double grownAlong(const Cloth& cloth, int t, const Eigen::Vector2d& direction);

/// Averages the growth of each triangle with that of the triangles across its edges, `passes` times.
void smoothGrowth(const Cloth& cloth, int passes, std::vector<Mat2>& growth);

}  // namespace ease
