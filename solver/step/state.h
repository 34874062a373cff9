// Positions and velocities of the cloth's vertices.
#pragma once

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct State {
  Positions positions;   // n x 3, m
  Positions velocities;  // n x 3, m/s
};

}  // namespace ease
