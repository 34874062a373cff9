// Isotropic remeshing: the same surface with triangles of nearly one size (Botsch and Kobbelt 2004, as implemented in
// CGAL's Polygon Mesh Processing).
#pragma once

#include <string>

#include "solver/base/error.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// `mesh` with edges of about `edge_length` (m).  The boundary is resampled first, its vertices on the old boundary, at
/// least eight to a loop.
TriangleMesh remeshed(const TriangleMesh& mesh, double edge_length);

/// The same with about `vertices` vertices, within 2.5 %.  Throws ComputationError, naming `name`, where no edge length
/// leads to that.  `pause`: before every trial.
TriangleMesh remeshedTo(const TriangleMesh& mesh, int vertices, const std::string& name, const Pause& pause = nullptr);

}  // namespace ease
