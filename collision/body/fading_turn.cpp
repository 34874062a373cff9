#include "collision/body/fading_turn.h"

#include <algorithm>
#include <cmath>

namespace ease {
namespace {

constexpr double kEase = 0.12;  // share of the ramp, at either end, in which its slope changes

/// Rises from 0 to 1 over [0, 1]: linear, with a parabola at either end.  Its largest slope is 1 / (1 - kEase).
double ramp(double s) {
  if (s <= 0.0) return 0.0;
  if (s >= 1.0) return 1.0;
  if (s > 0.5) return 1.0 - ramp(1.0 - s);
  if (s < kEase) return 0.5 * s * s / (kEase * (1.0 - kEase));
  return (s - 0.5 * kEase) / (1.0 - kEase);
}

/// Rotation by a share of the turn (axis times angle, rad).
Eigen::Matrix3d rotation(const Vec3& turn, double share) {
  const double angle = turn.norm();
  if (angle == 0.0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(share * angle, turn / angle).toRotationMatrix();
}

}  // namespace

double turnWeight(const FadingTurn& turn, const Vec3& x) {
  const Vec3 arm = x - turn.joint;
  const double distance = arm.norm();
  const double alpha = std::atan2(turn.limb.cross(arm).norm(), turn.limb.dot(arm));
  const double outward = ramp((distance - turn.near) / (turn.far - turn.near));
  const double none = turn.none_near + (turn.none_far - turn.none_near) * outward;
  return ramp((none - alpha) / (none - turn.full));
}

Vec3 turned(const FadingTurn& turn, const Vec3& x) {
  const double weight = turnWeight(turn, x);
  if (weight == 0.0) return x;  // exactly
  return turn.joint + rotation(turn.turn, weight) * (x - turn.joint);
}

Eigen::Isometry3d wholeTurn(const FadingTurn& turn) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.translate(turn.joint).rotate(rotation(turn.turn, 1.0)).translate(-turn.joint);
  return motion;
}

FadingTurn movedTurn(const Eigen::Isometry3d& motion, const FadingTurn& turn) {
  FadingTurn moved = turn;
  moved.joint = motion * turn.joint;
  moved.limb = motion.linear() * turn.limb;
  moved.turn = motion.linear() * turn.turn;
  return moved;
}

}  // namespace ease
