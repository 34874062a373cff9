// Meshes the surface where a signed distance is zero with evenly sized, well-shaped triangles.
//
// The distance is sampled on an OpenVDB grid near the surface; OpenVDB's volumeToMesh makes polygons of it, which are
// divided into triangles and relaxed on the exact surface (surface_relaxation.h).
#pragma once

#include "collision/body/distance_field.h"

namespace ease {

/// Meshes the surface `field` = 0 within the box from `lower` to `upper` (m).  `voxel`: distance between samples and
/// about the length of the edges, m.  The mesh is oriented outwards, and closed if the surface is.  The length of the
/// field's gradient must not be much above one.  Details thinner than two voxels may be lost.
TriangleMesh isoSurface(const DistanceField& field, const Vec3& lower, const Vec3& upper, double voxel);

}  // namespace ease
