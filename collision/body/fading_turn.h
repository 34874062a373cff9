// Skinning by turns that fade out around a joint: points on the limb follow the whole turn, points off it less, by
// their angle from the limb.
//
//   joint   centre of the turn, m          w(alpha)  1 |--.
//   limb    unit direction of the limb                 |   `.
//   alpha   angle between limb and x - joint         0 |_____`.___ alpha
//   turn    axis times angle, rad                        full  none
//
// Every point keeps its distance from the joint, so that nothing collapses.  Where angle * |w'| < 1 the map turns
// each circle around the axis monotonically onto itself: it is one to one, and so is any sequence of such turns, hence
// a skin that did not intersect itself still doesn't.
#pragma once

#include <Eigen/Geometry>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct FadingTurn {
  Vec3 joint;
  Vec3 limb;
  Vec3 turn;
  double full;       // rad: the whole turn up to this angle from the limb
  double none_near;  // rad: no turn from this angle on, at `near` from the joint and less
  double none_far;   // rad: the same at `far` from the joint and more
  double near, far;  // m
};

/// Share of the turn that `x` takes part in, 0 to 1.
double turnWeight(const FadingTurn& turn, const Vec3& x);

/// `x` after the turn.
Vec3 turned(const FadingTurn& turn, const Vec3& x);

/// The whole turn, as points on the limb see it.
Eigen::Isometry3d wholeTurn(const FadingTurn& turn);

/// The same turn where the limb has already been moved.
FadingTurn movedTurn(const Eigen::Isometry3d& motion, const FadingTurn& turn);

}  // namespace ease
