// The shape that the cloth has where nothing acts on it.
#pragma once

#include <vector>

#include "solver/mesh/triangle_gradient.h"

namespace ease {

struct RestShape {
  Positions positions;      // in space, m
  std::vector<Mat2> edges;  // two edges of every triangle laid flat in the material's plane (columns), m
};

}  // namespace ease
