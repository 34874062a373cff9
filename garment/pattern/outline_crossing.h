// Whether the outline of a flat piece crosses itself: the piece would then need the same cloth twice.
#pragma once

#include <utility>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Whether two edges of the closed outline cross in the plane of the first two coordinates.
bool crossesItself(const std::vector<int>& outline, const Positions& x);

/// The pairs of edges that cross, each by the numbers of the vertices where they begin, the smaller one first.
std::vector<std::pair<size_t, size_t>> crossings(const std::vector<int>& outline, const Positions& x);

/// Where segments a-b and c-d cross, as shares of the way along both; false if they do not.  Parallel ones do not.
bool crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d,
              double& along_ab, double& along_cd);

}  // namespace ease
