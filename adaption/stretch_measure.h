// Stretch of the cloth in each triangle.
//
//   F = U diag(sigma_1, sigma_2) Vᵀ, 3x2: sigma_1 >= sigma_2 principal stretches, dimensionless; 1 is unstretched
#pragma once

#include <vector>

#include "solver/model/cloth.h"

namespace ease {

struct Stretch {
  double sigma_1, sigma_2;    // principal
  double warp, weft;          // |f_u|, |f_v|
  Eigen::Vector2d direction;  // unit, of sigma_1 in the material's plane: first column of V
};

/// Principal stretches and their direction from the metric FᵀF, in closed form.
Stretch principalStretch(const Mat2& metric);

/// Computes the stretch of each triangle for vertices at x.
void measureStretch(const Cloth& cloth, const Positions& x, std::vector<Stretch>& stretch);

/// Summary of a set of stretches.
struct StretchStatistics {
  double max = 0.0, p99 = 0.0;
  double share_over_limit = 0.0;       // of the triangles, 0 to 1
  double taut_share_over_limit = 0.0;  // of all triangles, those over the limit that are taut
};

/// Summarises one stretch per triangle; the share counts those above 1 + limit.
StretchStatistics stretchStatistics(std::vector<double> values, double limit);

/// Whether a triangle over the limit is crumpled and not taut: it is sheared and compressed across, sigma_2 < 1, while
/// neither its warp nor its weft is stretched by more than half the limit.  More cloth would not relieve it: its
/// wrinkles are finer than the triangles can follow.
bool isCrumpled(const Stretch& stretch, double limit);

/// Summarises the larger principal stretch of all triangles at one moment.
StretchStatistics momentStatistics(const std::vector<Stretch>& stretch, double limit);

/// The larger principal stretch sigma_1 of each triangle.
std::vector<double> firstStretches(const std::vector<Stretch>& stretch);

}  // namespace ease
