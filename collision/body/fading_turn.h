// Skinning by a turn that fades out around a joint: points on the limb follow the whole turn, other points a share w of
// it that falls with their angle from the limb.
//
//   joint   centre of the turn, m          w(alpha)  1 |--.
//   limb    unit direction of the limb                 |   `.
//   alpha   angle between limb and x - joint         0 |_____`.___ alpha
//   turn    axis times angle, rad                        full  none
//
// Every point keeps its distance from the joint, so that the limb does not collapse.  Where angle * |w'| < 1 the map
// turns each circle around the axis monotonically onto itself.  It is then one to one, and so is any sequence of such
// turns: a skin that does not intersect itself before the turns does not do so after them.
#pragma once

#include <Eigen/Geometry>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct FadingTurn {
  Vec3 joint;
  Vec3 limb;
  Vec3 turn;
  double full;       // rad: points up to this angle from the limb follow the whole turn
  double none_near;  // rad: beyond this angle nothing turns, for points up to `near` from the joint
  double none_far;   // rad: that angle for points beyond `far` from the joint
  double near, far;  // m
};

/// Share w of the turn that `x` follows, 0 to 1.
double turnWeight(const FadingTurn& turn, const Vec3& x);

/// Position of `x` after the turn, m.
Vec3 turned(const FadingTurn& turn, const Vec3& x);

/// The rigid motion of points on the limb.
Eigen::Isometry3d wholeTurn(const FadingTurn& turn);

/// The turn of a limb that `motion` has already moved.
FadingTurn movedTurn(const Eigen::Isometry3d& motion, const FadingTurn& turn);

}  // namespace ease
