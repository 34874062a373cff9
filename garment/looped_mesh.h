// An open mesh with named boundary loops.  The garment tools change it one after the other.
#pragma once

#include <string>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct NamedLoop {
  std::string name;
  std::vector<int> vertices;  // in order along the loop, without repetition
};

struct LoopedMesh {
  TriangleMesh mesh;
  std::vector<NamedLoop> loops;
};

/// Finds the index of the loop called `name`.  If there is none, throws InputError, which begins with `where` and lists
/// the names that exist.
size_t loopNamed(const std::vector<NamedLoop>& loops, const std::string& name, const std::string& where);

/// Positions of these vertices, m.
std::vector<Vec3> positionsOf(const std::vector<int>& vertices, const Positions& positions);

/// Names the boundary loops of `mesh` after the loops of `before`: each takes the name of the loop it lies nearest to.
/// Throws ComputationError naming a loop that was lost, for example if the mesh is too coarse to pass around an arm.
LoopedMesh withLoopNames(TriangleMesh mesh, const LoopedMesh& before);

}  // namespace ease
