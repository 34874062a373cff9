// The moving body at one moment: where its surface is between two poses, and the level set that stands for it there.
//
//   x_v(tau) = (1 - tau) a_v + tau b_v, m     a, b: vertices in the pose of the level set and in the pose next to it
//   tau                                       how far the body has moved from a to b, 0 to 1
//
// The level set is that of pose a; between the poses its lookups are carried along with the surface (contacts.h).
#pragma once

#include <Eigen/Geometry>

#include "collision/level_set.h"
#include "collision/triangle_tree.h"
#include "solver/mesh/triangle_gradient.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Refers to data that a MovingBody owns.
struct BodyMoment {
  LevelSet* level_set;         // of pose a
  const TriangleTree* tree;    // of pose a
  const Triangles* triangles;  // of the body
  const Positions* at;         // vertices in pose a, m
  const Positions* towards;    // vertices in pose b, m: the pose before or after a
  double tau = 0.0;

  /// Position of vertex v at this moment, m.
  Vec3 position(int v) const { return (1.0 - tau) * at->row(v) + tau * towards->row(v); }

  /// Positions of all vertices at this moment, m.
  void positions(Positions& x) const { x = (1.0 - tau) * *at + tau * *towards; }

  /// Mean motion of the corners of triangle t over the whole way from a to b, m.
  Vec3 motionOfTriangle(int t) const {
    Vec3 motion = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      const int v = (*triangles)(t, k);
      motion += (towards->row(v) - at->row(v)).transpose();
    }
    return motion / 3.0;
  }

  /// Mean of the corners of triangle t at this moment, m.
  Vec3 centroid(int t) const {
    const auto corners = triangles->row(t);
    return (position(corners[0]) + position(corners[1]) + position(corners[2])) / 3.0;
  }

  /// Orthonormal directions that turn with triangle t: along its first edge, in its plane, and along its normal.
  Mat3 frame(int t) const {
    const auto corners = triangles->row(t);
    const Vec3 a = position(corners[0]), along = (position(corners[1]) - a).normalized();
    const Vec3 normal = along.cross(position(corners[2]) - a).normalized();
    Mat3 frame;
    frame << along, normal.cross(along), normal;
    return frame;
  }
};

/// Displacement from `before` to `now`, m, of a point that is carried rigidly by triangle t and ends at x.
inline Vec3 carriedMotion(const Vec3& x, int t, const BodyMoment& before, const BodyMoment& now) {
  const Vec3 local = now.frame(t).transpose() * (x - now.centroid(t));
  return x - before.centroid(t) - before.frame(t) * local;
}

}  // namespace ease
