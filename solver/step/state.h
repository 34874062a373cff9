// Positions and velocities of the cloth's vertices.
#pragma once

#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct State {
  Positions positions;   // n x 3, m
  Positions velocities;  // n x 3, m/s
  // With friction: force of the contact plane on each sample at the end of the last step, N, then that of each sample's
  // second plane that rubs. Empty: none is known, and the next step finds them first.
  std::vector<double> normal_forces = {};
};

/// Vertices that are held exactly at given positions.
struct Pins {
  std::vector<int> vertices;
  std::vector<Vec3> positions;  // at the end of the step, m
};

}  // namespace ease
