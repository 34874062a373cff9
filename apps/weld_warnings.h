// Warnings about the welding of a mesh file (solver/mesh/weld.h).
#pragma once

#include "apps/scene.h"
#include "solver/mesh/weld.h"

namespace ease {

/// Warns of edges that could not be welded, of welded vertices, and of vertices that no triangle uses.  `file`: name of
/// the mesh file; `table`: the table of the scene whose key `weld` keeps vertices apart.
void warnOfWeld(const Weld& weld, const std::string& file, const std::string& table, const Warn& warn);

}  // namespace ease
