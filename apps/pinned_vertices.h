// The vertices that a scene pins: the vertices of a boundary loop, vertices in a list, or vertices within a ball.
#pragma once

#include <vector>

#include "apps/scene.h"
#include "solver/mesh/topology.h"

namespace ease {

/// Finds the vertices of each [[garment.pin]] on the input's garment.  A vertex that an earlier pin holds in the same
/// way is left out of the later one.  Throws InputError naming the pin if the garment has no such loop or vertex, if no
/// vertex lies in the ball, or if one vertex is pinned both to the body and in space.
std::vector<std::vector<int>> pinnedVertices(const Scene& scene, const SceneInput& input, const Topology& topology);

}  // namespace ease
