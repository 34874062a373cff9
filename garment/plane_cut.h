// Cuts a triangle mesh with a plane.
//
//      \   /\   /           triangles across the plane are cut along it, those beyond it are removed
//     --\-/--\-/--  plane   vertices close to the plane are moved onto it to avoid slivers
//        v    v
#pragma once

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct Plane {
  Vec3 point;   // m
  Vec3 normal;  // unit length; points to the side that is removed
};

/// Signed distance to the plane, m, positive on the side that is removed.
inline double planeDistance(const Plane& plane, const Vec3& x) {
  return plane.normal.dot(x - plane.point);
}

/// Returns the part of the mesh behind the plane.  Vertices within `snap` (m) of the plane are moved onto it.
TriangleMesh cutByPlane(const TriangleMesh& mesh, const Plane& plane, double snap);

}  // namespace ease
