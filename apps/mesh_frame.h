// The unit and the axes of a mesh file, and the change to what Ease computes in: metres, y up, the wearer faces +z.
//
//   [body]                 the same keys in [garment]; there, what [body] says is the default
//   unit = "cm"            "m", "dm", "cm", "mm", "in" or "ft"; by default "m"
//   up = "z"               by default "y"
//   facing = "-y"          where the wearer looks; by default "z", or "-y" where z is up
#pragma once

#include "apps/toml_table.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct MeshFrame {
  double metres_per_unit = 1.0;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  // from the file's axes to Ease's

  bool changesNothing() const { return metres_per_unit == 1.0 && turn.isIdentity(0.0); }
};

/// Reads the keys unit, up and facing. Throws InputError like `table` where they make no sense.
MeshFrame readFrame(const TomlTable& table, const MeshFrame& fallback = {});

/// Changes coordinates of a file to Ease's.
void toMetres(const MeshFrame& frame, Positions& positions);

/// The keys that would mend a body of this size, as a sentence; empty where none would.  `size`: along x, y, z, m.
std::string frameAdvice(const Vec3& size);

}  // namespace ease
