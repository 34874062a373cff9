// Interpolation of a body between two poses in the gradient domain (Xu et al. 2006; Sumner and Popovic 2004).
//
// Every triangle turns and stretches on its own: its deformation gradient from the first pose to the second is R S
// (rotation, symmetric stretch), and at s in [0, 1] it is exp(s log R) ((1 - s) I + s S).  The vertices whose triangle
// gradients are nearest to these solve the gradient system (gradient_system.h).  Both poses come out exactly at their
// ends.
//
// Rotation vectors near a half turn are ambiguous; each triangle takes the branch nearest to a neighbour's, spreading
// from the triangle that turns least, so that the surface does not tear where an arm turns by more than 180 degrees.
//
// A pose costs a rotation a triangle and a solve; many between the same two come from a few (pose_interpolation.h).
#pragma once

#include "solver/linear/gradient_system.h"

namespace ease {

class GradientInterpolation {
 public:
  /// Factors.  `ordering`: of the body's systems, or empty.  Throws ComputationError.
  GradientInterpolation(const Triangles& triangles, const Positions& from, const Positions& to,
                        std::span<const int> ordering = {});

  /// The body at s in [0, 1], m.
  void at(double s, Positions& x);

  /// By which a triangle turns the most, radians; beyond pi where it was unwound.
  double largestTurn() const;

 private:
  void findParts(const Positions& from, const Positions& to);
  void findRotations(const Positions& to, std::span<const Mat2> rest_inverse);
  void unwindRotations(const Triangles& triangles);

  struct Part {
    int anchor;               // vertex that moves least
    std::vector<int> steady;  // the half of its vertices that moves least: its mean goes straight
    Vec3 from, to;            // that mean at either end
  };

  Triangles triangles_;
  Positions from_, to_;
  GradientSystem system_;
  std::vector<int> part_of_;      // of each vertex
  std::vector<Part> parts_;       // connected
  std::vector<Mat32> frames_;     // of each triangle in the first pose: orthonormal, 3x2
  std::vector<Vec3> rotations_;   // rotation vectors, radians
  std::vector<Mat32> stretches_;  // S times frame
  std::vector<Mat32> targets_;
  Positions anchors_;
};

}  // namespace ease
