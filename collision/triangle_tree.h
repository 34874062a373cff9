// Bounding-box tree over the triangles of a moving surface: exact closest points, inside or outside.
//
// Built once for the connectivity, refit for every pose.  The surface is closed, its triangles counter-clockwise from
// outside.  Where it passes through itself or one part lies in another, the body is the union of all that it encloses:
// the points with a positive winding number.  A part of the surface that lies within that union bounds nothing and
// is called buried.  Of a surface without triangles nothing is near and every point is outside.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <span>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct ClosestPoint {
  int triangle = -1;      // -1: nothing within the distance asked for
  Vec3 point;             // on the surface, m
  double distance = 0.0;  // >= 0, m
  Vec3 pseudonormal;  // of the face, edge or vertex that `point` lies on (Baerentzen and Aanaes 2005), not normalised
};

/// What a triangle is to the union: not known yet, a part of its boundary, partly so, or no part of it.
enum class Exposure : unsigned char { unknown, boundary, crossing, buried };

class TriangleTree {
 public:
  TriangleTree(const Positions& positions, const Triangles& triangles);
  ~TriangleTree();
  TriangleTree(TriangleTree&&) noexcept;
  TriangleTree& operator=(TriangleTree&&) noexcept;

  /// Moves the surface; same connectivity.
  void refit(const Positions& positions);

  /// Closest point of the surface within `max_distance`; `hint` is a triangle that is likely close (-1: none) and
  /// changes nothing but the time taken.  Of triangles equally close, the one with the lowest index.
  ClosestPoint closest(const Vec3& x, double max_distance, int hint = -1) const;

  /// Closest point of the union's boundary; `distance` has a sign, negative inside, and is +-max_distance where nothing
  /// is within that.  A crossing triangle counts only if its own closest point is exposed, so that the depth within an
  /// overlap errs by up to a triangle's size near the seam; everywhere else it is exact.  `exposures`, one a triangle,
  /// saves ray casts; empty: all unknown.
  ClosestPoint closestOfUnion(const Vec3& x, double max_distance, int hint = -1,
                              std::span<const Exposure> exposures = {}) const;

  /// Distance to the surface, m, negative inside; right also where the surface overlaps itself.  At most `max_distance`
  /// in size.
  double signedDistance(const Vec3& x, double max_distance) const;

  /// How many times the surface winds around x: 0 outside, 1 inside, 2 in an overlap.
  int windingNumber(const Vec3& x) const;

  /// Winding number just outside `triangle` near `point`, which lies on it: 0 where the triangle bounds the union.
  int windingOutside(int triangle, const Vec3& point) const;

  Eigen::AlignedBox3d bounds() const;

  struct Data;  // triangle_tree_data.h
  const Data& data() const { return *data_; }

 private:
  std::unique_ptr<Data> data_;
};

}  // namespace ease
