// Takes the state of a garment over to another mesh of it: a longer skirt, another resolution, one boundary more.
//
// Both meshes are made on the same pose.  A new vertex within kSamePlace of the old mesh there is tied to it, and goes
// where the old cloth is now.  Any other (the new part of a skirt) moves as rigidly as the cloth around the nearest
// tied vertex did (Kabsch 1976).
#pragma once

#include <vector>

#include "solver/mesh/topology.h"

namespace ease {

struct CarriedCloth {
  Positions positions, velocities;  // of the new vertices, m and m/s
  std::vector<double> growth;       // scale of every new triangle's rest edges: what the old cloth there had grown
  int tied = 0;                     // new vertices that lie on the old mesh
};

constexpr double kSamePlace = 0.02;  // m

/// `made`, `now`, `velocities`: the old mesh as it was made, and its state.  `area_ratio`: rest area over first rest
/// area of every old triangle.
CarriedCloth carryOver(const TriangleMesh& made, const Positions& now, const Positions& velocities,
                       const std::vector<double>& area_ratio, const TriangleMesh& wanted, const Topology& topology);

}  // namespace ease
