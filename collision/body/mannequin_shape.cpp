#include "collision/body/mannequin_shape.h"

#include <algorithm>
#include <vector>

namespace ease {
namespace {

/// One limb and the blend (m) with which it joins the limbs listed before it.
struct Part {
  Limb limb;
  double blend;
};

const Distance kNothing = {1e3, Vec3::Zero()};
const Vec3 kAcross = Vec3::UnitX(), kUp = Vec3::UnitY(), kDeep = Vec3::UnitZ();
constexpr double kHip = 0.06, kShoulderBlend = 0.06, kBetweenLegs = 0.012, kSole = 0.012;  // blends, m

/// Trunk and head, on the plane x = 0.
const std::vector<Part> kTrunk = {
    {taperedLimb({0, 0.925, -0.008}, {0, 1.06, 0.004}, 0.163, 0.120, kDeep, 0.66), 0},       // pelvis
    {taperedLimb({0, 1.05, 0.004}, {0, 1.15, 0.002}, 0.118, 0.120, kDeep, 0.74), 0.04},      // waist
    {taperedLimb({0, 1.15, 0}, {0, 1.285, -0.012}, 0.122, 0.146, kDeep, 0.70), 0.04},        // rib cage
    {taperedLimb({0, 1.38, -0.024}, {0, 1.53, -0.002}, 0.057, 0.054), 0.05},                 // neck
    {taperedLimb({0, 1.616, -0.014}, {0, 1.60, 0.006}, 0.087, 0.086, kAcross, 0.84), 0.02},  // skull
    {taperedLimb({0, 1.610, 0.034}, {0, 1.522, 0.052}, 0.066, 0.042, kAcross, 0.86), 0.03},  // face
    {taperedLimb({0, 1.598, 0.094}, {0, 1.572, 0.100}, 0.010, 0.014), 0.02},                 // nose
};

/// The left leg, from the buttock down.
const std::vector<Part> kLeg = {
    {taperedLimb({0.088, 0.885, 0.0}, {0.098, 0.49, 0.008}, 0.087, 0.053), 0},                 // thigh
    {taperedLimb({0.070, 0.885, -0.052}, {0.082, 0.82, -0.040}, 0.078, 0.070), 0.05},          // buttock
    {taperedLimb({0.098, 0.49, 0.008}, {0.106, 0.075, -0.024}, 0.051, 0.033), 0.015},          // shin
    {taperedLimb({0.100, 0.40, -0.016}, {0.105, 0.27, -0.024}, 0.045, 0.036), 0.03},           // calf
    {taperedLimb({0.106, 0.030, -0.045}, {0.106, 0.055, -0.015}, 0.034, 0.036), 0.03},         // heel
    {taperedLimb({0.108, 0.040, 0.0}, {0.122, 0.020, 0.130}, 0.044, 0.040, kUp, 0.72), 0.03},  // foot
};

/// The left arm, from the neck outwards.
const std::vector<Part> kArm = {
    {taperedLimb({0.055, 1.375, -0.018}, {0.160, 1.388, -0.012}, 0.062, 0.056), 0},     // shoulder girdle
    {taperedLimb({0.030, 1.462, -0.030}, {0.135, 1.412, -0.020}, 0.030, 0.034), 0.05},  // trapezius
    {taperedLimb({0.078, 1.285, 0.046}, {0.072, 1.250, 0.050}, 0.052, 0.052), 0.06},    // breast
    {taperedLimb({0.085, 1.31, -0.060}, {0.080, 1.22, -0.045}, 0.045, 0.045), 0.05},    // shoulder blade
    {taperedLimb({0.170, 1.388, -0.010}, {0.245, 1.386, -0.010}, 0.060, 0.048), 0.03},  // deltoid
    {taperedLimb({0.200, 1.385, -0.010}, {0.435, 1.385, -0.010}, 0.053, 0.041), 0.02},  // upper arm
    {taperedLimb({0.435, 1.385, -0.010}, {0.675, 1.385, 0.0}, 0.040, 0.027), 0.01},     // forearm
    {taperedLimb({0.475, 1.385, -0.006}, {0.555, 1.384, -0.004}, 0.040, 0.036), 0.03},  // muscle of the forearm
    {taperedLimb({0.705, 1.385, 0.002}, {0.765, 1.384, 0.003}, 0.036, 0.038, kUp, 0.50), 0.03},  // palm
    {taperedLimb({0.770, 1.384, 0.002}, {0.835, 1.381, 0.0}, 0.036, 0.028, kUp, 0.46), 0.012},   // fingers
    {taperedLimb({0.700, 1.381, 0.026}, {0.765, 1.376, 0.060}, 0.017, 0.014), 0.015},            // thumb
};

/// Union of the parts, to be joined with `known` by `blend` (m): leaves out parts too far away to affect that.
Distance unionOf(const std::vector<Part>& parts, const Vec3& x, const Distance& known, double blend) {
  Distance joined = kNothing;
  for (const Part& part : parts)
    if (!isFurther(part.limb, x, std::min(joined.value, known.value + blend) + part.blend))
      joined = smoothUnion(joined, limbDistance(part.limb, x), part.blend);
  return joined;
}

/// Union of the left side's parts and their mirror images, which are joined by `between` (m).
Distance bothSides(const std::vector<Part>& left, const Vec3& x, double between, const Distance& known, double blend) {
  const Vec3 mirror(-1.0, 1.0, 1.0);
  Distance right = unionOf(left, x.cwiseProduct(mirror), known, blend + between);
  right.gradient.x() = -right.gradient.x();
  return smoothUnion(unionOf(left, x, known, blend + between), right, between);
}

}  // namespace

Distance mannequinDistance(const Vec3& x) {
  Distance body = unionOf(kTrunk, x, kNothing, 0.0);
  body = smoothUnion(body, bothSides(kArm, x, kShoulderBlend, body, kShoulderBlend), kShoulderBlend);
  body = smoothUnion(body, bothSides(kLeg, x, kBetweenLegs, body, kHip), kHip);
  return smoothIntersection(body, {-x.y(), -kUp}, kSole);
}

}  // namespace ease
