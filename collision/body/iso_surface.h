// The zero surface of a signed distance as evenly sized, well-shaped triangles.
//
// Sampled on an OpenVDB grid near the surface, cut into polygons by its volumeToMesh, then relaxed on the exact
// surface.
#pragma once

#include "collision/body/surface_relaxation.h"

namespace ease {

/// The surface where `field` is zero within the box from `lower` to `upper` (m), sampled every `voxel` (m), which is
/// about the length of the edges.  Closed if the surface is; oriented outwards.  The field's slope must not be much
/// above one; details thinner than two voxels may be lost.
TriangleMesh isoSurface(const DistanceField& field, const Vec3& lower, const Vec3& upper, double voxel);

}  // namespace ease
