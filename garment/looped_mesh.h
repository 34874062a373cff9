// An open mesh with named boundary loops, on which the garment tools work one after the other.
#pragma once

#include <string>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct NamedLoop {
  std::string name;
  std::vector<int> vertices;  // in order, each once
};

struct LoopedMesh {
  TriangleMesh mesh;
  std::vector<NamedLoop> loops;
};

/// Index of the loop called `name`.  Throws InputError, with `where` and the names that exist, if there is none.
size_t loopNamed(const std::vector<NamedLoop>& loops, const std::string& name, const std::string& where);

/// Positions of these vertices, m.
std::vector<Vec3> positionsOf(const std::vector<int>& vertices, const Positions& positions);

/// `mesh` with the names of `before`'s loops: each boundary loop has that of the one it lies nearest to.  Throws
/// ComputationError naming a loop that was lost, as when the mesh is too coarse to pass around an arm.
LoopedMesh withLoopNames(TriangleMesh mesh, const LoopedMesh& before);

}  // namespace ease
