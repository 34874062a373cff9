// Garments for the built-in body, made on its T-pose.
//
// A garment is the surface at a small distance from the body, a larger one at the hem, with hollows bridged; the dress
// widens into a skirt.  Planes cut it at neck, sleeves and hem; then it is remeshed evenly.
#pragma once

#include <string>

#include "collision/body/body_size.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

constexpr int kMinBuiltinVertices = 300, kMaxBuiltinVertices = 100000;

/// Makes the garment called "t-shirt" or "dress" with `vertices` vertices (300 to 100,000; met within 2.5 %), evenly
/// sized triangles and four boundary loops that lie in planes.  Every vertex, edge midpoint and centroid is at least
/// `offset` (m, 0 to 0.05) outside the mannequin's T-pose.  Throws InputError naming an unknown garment or an
/// impossible number.  `measures`: of the mannequin that wears it.
TriangleMesh builtinGarment(const std::string& name, int vertices, double offset, const BodyMeasures& measures = {});

}  // namespace ease
