// Bounding-box tree over the triangles of a moving surface: finds exact closest points, and whether a point is inside.
//
// The tree is built once for the connectivity and refit for every pose.  The surface is closed; its triangles are
// counter-clockwise seen from outside.  Where it passes through itself or one part lies in another, the body is the
// union of the enclosed volumes: the points with a positive winding number.  A part of the surface that lies inside
// that union does not bound it and is called buried.  A surface without triangles has no closest point and encloses
// nothing.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <span>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct ClosestPoint {
  int triangle = -1;      // -1: no triangle is within the maximum distance
  Vec3 point;             // on the surface, m
  double distance = 0.0;  // >= 0, m
  Vec3 pseudonormal;      // of the face, edge or vertex at `point` (Baerentzen and Aanaes 2005), not normalised
};

/// How much of a triangle lies on the boundary of the union: not known yet, all (boundary), a part (crossing) or
/// nothing (buried).
enum class Exposure : unsigned char { unknown, boundary, crossing, buried };

class TriangleTree {
 public:
  TriangleTree(const Positions& positions, const Triangles& triangles);
  ~TriangleTree();
  TriangleTree(TriangleTree&&) noexcept;
  TriangleTree& operator=(TriangleTree&&) noexcept;

  /// Moves the surface to these positions, m; the triangles of the constructor stay.
  void refit(const Positions& positions);

  /// Finds the closest point of the surface within `max_distance` (m).  If several triangles are equally close, the one
  /// with the lowest index counts.  `hint` is a triangle that is likely close (-1: none); it only makes the search
  /// faster.
  ClosestPoint closest(const Vec3& x, double max_distance, int hint = -1) const;

  /// Finds the closest point of the union's boundary.  `distance` is negative inside, and +-max_distance if the
  /// boundary is further than that.  A crossing triangle counts only if its own closest point lies on the boundary of
  /// the union: near the seam of an overlap the depth therefore errs by up to a triangle's size; elsewhere it is exact.
  /// `exposures`, one per triangle, saves ray casts; if it is empty, all are unknown.
  ClosestPoint closestOfUnion(const Vec3& x, double max_distance, int hint = -1,
                              std::span<const Exposure> exposures = {}) const;

  /// Signed distance to the union's boundary, m, negative inside, limited to +-max_distance.
  double signedDistance(const Vec3& x, double max_distance) const;

  /// Computes how often the surface winds around x: 0 outside, 1 inside, 2 where two parts overlap.
  int windingNumber(const Vec3& x) const;

  /// Computes the winding number just outside `triangle` near `point`, which lies on it.  It is 0 where the triangle
  /// bounds the union.
  int windingOutside(int triangle, const Vec3& point) const;

  Eigen::AlignedBox3d bounds() const;

  struct Data;  // triangle_tree_data.h
  const Data& data() const { return *data_; }

 private:
  std::unique_ptr<Data> data_;
};

}  // namespace ease
