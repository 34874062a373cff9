// Where the cloth is and how it moves.
#pragma once

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct State {
  Positions positions;   // n x 3, m
  Positions velocities;  // n x 3, m/s
};

}  // namespace ease
