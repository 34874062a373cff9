// Interpolation of a body between two poses in the gradient domain (Xu et al. 2006; Sumner and Popovic 2004).
//
// Every triangle turns and stretches on its own: its deformation gradient from the first pose to the second is R S
// (rotation, symmetric stretch), and at s in [0, 1] it is exp(s log R) ((1 - s) I + s S).  The vertices whose triangle
// gradients are nearest to these solve the gradient system (gradient_system.h).  At s = 0 and s = 1 the result is
// exactly the given pose.
//
// Rotation vectors near a half turn are ambiguous.  Each triangle takes the one nearest to a neighbour's, spreading
// from the triangle that turns least, so that the surface does not tear where an arm turns by more than 180 degrees.
//
// A pose costs a rotation a triangle and a solve; pose_interpolation.h makes many poses from a few of these.
#pragma once

#include "solver/linear/gradient_system.h"

namespace ease {

class GradientInterpolation {
 public:
  /// Factors the system.  `ordering`: an elimination ordering (systemOrdering()), or empty to compute one.  Throws
  /// ComputationError if the system is not positive definite.
  GradientInterpolation(const Triangles& triangles, const Positions& from, const Positions& to,
                        std::span<const int> ordering = {});

  /// Computes the vertices at s in [0, 1], m.
  void at(double s, Positions& x);

  /// Largest rotation of a triangle, radians; may be above pi.
  double largestTurn() const;

 private:
  /// Finds the connected parts and how each moves as a whole.
  void findParts(const Positions& from, const Positions& to);
  /// Computes rotation and stretch of each triangle.
  void findRotations(const Positions& to, std::span<const Mat2> rest_inverse);
  /// Chooses among the rotation vectors of the same rotation the one nearest to a neighbour's.
  void unwindRotations(const Triangles& triangles);

  struct Part {
    int anchor;               // vertex that moves least
    std::vector<int> steady;  // the half of its vertices that moves least; their mean moves in a straight line
    Vec3 from, to;            // that mean in either pose, m
  };

  Triangles triangles_;
  Positions from_, to_;
  GradientSystem system_;
  std::vector<int> part_of_;      // number of the part of each vertex
  std::vector<Part> parts_;       // connected parts of the surface
  std::vector<Mat32> frames_;     // orthonormal basis of each triangle's plane in the first pose, 3x2
  std::vector<Vec3> rotations_;   // rotation vectors, radians
  std::vector<Mat32> stretches_;  // S times frame
  std::vector<Mat32> targets_;
  Positions anchors_;
};

}  // namespace ease
