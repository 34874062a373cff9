// A tapered limb with round ends and an elliptical cross-section, and the smooth union of two shapes.
//
//        .--------.___            a, b    centres of the end spheres, m
//      (  a           b )         r_a, r_b their radii, m; |r_a - r_b| < |b - a|
//        `--------'```            q       radius along `thin` over the radius across it (1: round)
//
// The limb is a round cone in a space stretched by 1/q along `thin`.  The cone's distance there, divided by the length
// of its gradient, is the limb's distance to first order near the surface, and exact for q = 1.  The union is the
// polynomial smooth minimum of third degree (I. Quilez, "smooth minimum"); it differs from the sharp minimum only where
// the two distances differ by less than the blend.
#pragma once

#include "collision/body/distance_field.h"

namespace ease {

struct Limb {
  Vec3 a;
  double radius_a;
  Vec3 thin;         // unit
  double excess;     // 1/q - 1: the stretch of space is I + excess thin thin^T
  Vec3 direction;    // unit, from a to b in stretched space
  double length;     // |b - a| in stretched space, m
  double sine;       // of the cone's half opening angle; positive: b is the smaller end
  double tangent;    // of that angle
  Vec3 middle;       // centre of a ball that encloses the limb
  double enclosing;  // radius of that ball, m
  double min_ratio;  // lower bound of limbDistance() over the distance to that ball
};

/// Makes the limb from `a` to `b`; the other symbols are explained above.
Limb taperedLimb(const Vec3& a, const Vec3& b, double radius_a, double radius_b, const Vec3& thin = Vec3::UnitZ(),
                 double q = 1.0);

/// Signed distance of `x` to the limb.
Distance limbDistance(const Limb& limb, const Vec3& x);

/// Whether the limb is certainly further from `x` than `distance` (m).
bool isFurther(const Limb& limb, const Vec3& x, double distance);

/// Union of two shapes, rounded where their distances differ by less than `blend` (m; 0: sharp).  The value is never
/// above the smaller of the two; where they are equal, it is below it by blend / 6.
Distance smoothUnion(const Distance& first, const Distance& second, double blend);

/// Intersection of two shapes, rounded where their distances differ by less than `blend` (m; 0: sharp).
Distance smoothIntersection(const Distance& first, const Distance& second, double blend);

}  // namespace ease
