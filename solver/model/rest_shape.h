// The shape that the cloth has where nothing acts on it.
#pragma once

#include <vector>

#include "solver/mesh/triangle_gradient.h"

namespace ease {

struct RestShape {
  Positions positions;      // of the vertices in space, m
  std::vector<Mat2> edges;  // of each triangle, flat in the material's plane (rows: warp, weft), m
};

}  // namespace ease
