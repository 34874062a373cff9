// Finds a boundary loop of a garment by the name that people give it.
#pragma once

#include <string>
#include <vector>

#include "solver/mesh/topology.h"

namespace ease {

/// The loop that lies furthest along a direction by the mean of its vertices ("top" +y, "bottom" -y, "left" +x of the
/// wearer who faces +z, "right" -x), or by its index ("0", "1", ...).  Throws InputError naming the loops that exist,
/// also where two lie equally far, within 1 % of the mesh's diagonal.
const std::vector<int>& findLoop(const Topology& topology, const Positions& positions, const std::string& where);

}  // namespace ease
