// Finds a boundary loop of a garment by the name that users give it.
#pragma once

#include <string>
#include <vector>

#include "garment/looped_mesh.h"
#include "solver/mesh/topology.h"

namespace ease {

/// Finds the neck or the hem by its place on the garment, the loop whose mean vertex lies furthest along a direction,
/// or the loop with an index ("0", "1", ...).  The directions are "top" (+y), "bottom" (-y), "left" (+x, the left of a
/// wearer who faces +z) and "right" (-x). "neck" and "hem" are the loops on the middle of the upper and the lower half,
/// wherever sleeves and legs point.  Throws InputError naming the loops that exist if none is called `where` or two lie
/// equally far, within 1 % of the mesh's diagonal.
const std::vector<int>& findLoop(const Topology& topology, const Positions& positions, const std::string& where);

/// All boundary loops by the names that findLoop() takes: "neck", "hem", "left" and "right" where these are clear, else
/// their index.
std::vector<NamedLoop> nameLoops(const Topology& topology, const Positions& positions);

}  // namespace ease
