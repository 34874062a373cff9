// The mannequin in its T-pose as an implicit shape: a smooth union of limbs, symmetric about the plane x = 0.
#pragma once

#include "collision/body/limb.h"

namespace ease {

/// Positions of the left arm's joints in the T-pose, m.
namespace mannequin_joints {
inline const Vec3 kClavicle{0.02, 1.395, 0.0};
inline const Vec3 kShoulder{0.17, 1.385, -0.01};
inline const Vec3 kElbow{0.435, 1.385, -0.01};
}  // namespace mannequin_joints

/// Signed distance to the mannequin's T-pose, m, negative inside.  Outside it is a lower bound of the true distance,
/// but for the first-order error of limbDistance().
Distance mannequinDistance(const Vec3& x);

}  // namespace ease
