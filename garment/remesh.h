// Isotropic remeshing: covers a surface with triangles of nearly one size (Botsch and Kobbelt 2004, as implemented in
// CGAL's Polygon Mesh Processing).
#pragma once

#include <string>

#include "solver/base/error.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Remeshes with edges of about `edge_length` (m).  The boundary is resampled first: its new vertices lie on the old
/// boundary, at least eight on each loop.
TriangleMesh remeshed(const TriangleMesh& mesh, double edge_length);

/// Remeshes to about `vertices` vertices, within 2.5 %.  Throws ComputationError with `name` if no edge length
/// gives that number.  `pause` is called before each trial.
TriangleMesh remeshedTo(const TriangleMesh& mesh, int vertices, const std::string& name, const Pause& pause = nullptr);

}  // namespace ease
