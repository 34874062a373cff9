// The vertices that a scene's pins mean: those of a loop, those listed, or those in a ball.
#pragma once

#include <vector>

#include "apps/scene.h"
#include "solver/mesh/topology.h"

namespace ease {

/// Finds the vertices of each [[garment.pin]] on the input's garment.  Throws InputError naming the pin: a loop that
/// the garment does not have, no such vertex, an empty ball, a vertex that an earlier pin holds.
std::vector<std::vector<int>> pinnedVertices(const Scene& scene, const SceneInput& input, const Topology& topology);

}  // namespace ease
