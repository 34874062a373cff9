// A tapered limb with round ends and an elliptical cross-section, and the smooth union of two shapes.
//
//        .--------.___            a, b    centres of the end spheres, m
//      (  a           b )         r_a, r_b their radii, m; |r_a - r_b| < |b - a|
//        `--------'```            q       radius along `thin` over the radius across it (1: round)
//
// A round cone seen through a stretch of space by 1/q along `thin`: its distance, divided by the length of its
// gradient, is the distance to first order near the surface and exact for q = 1.  The union is the polynomial smooth
// minimum of third degree (I. Quilez, "smooth minimum"), which differs from the sharp one only within the blend.
#pragma once

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Signed distance (m, negative inside) and its gradient, of about unit length.
struct Distance {
  double value;
  Vec3 gradient;
};

struct Limb {
  Vec3 a;
  double radius_a;
  Vec3 thin;         // unit
  double excess;     // 1/q - 1: the stretch of space is I + excess thin thin^T
  Vec3 direction;    // unit, from a to b in stretched space
  double length;     // |b - a| in stretched space, m
  double sine;       // of the cone's half opening angle; positive: b is the smaller end
  double tangent;    // of the same angle
  Vec3 middle;       // centre of a ball that holds the limb
  double enclosing;  // its radius, m
  double least;      // least share of the distance to that ball which limbDistance() may return
};

/// The limb from `a` to `b`; for the other symbols see above.
Limb taperedLimb(const Vec3& a, const Vec3& b, double radius_a, double radius_b, const Vec3& thin = Vec3::UnitZ(),
                 double q = 1.0);

/// Distance of `x` to the limb.
Distance limbDistance(const Limb& limb, const Vec3& x);

/// Whether the limb is certainly further from `x` than `distance` (m).
bool isFurther(const Limb& limb, const Vec3& x, double distance);

/// Union of two shapes, rounded where their distances differ by less than `blend` (m; 0: sharp).  At most the smaller
/// of the two values, by blend / 6 where they are equal.
Distance smoothUnion(const Distance& first, const Distance& second, double blend);

/// Intersection of two shapes, rounded in the same way.
Distance smoothIntersection(const Distance& first, const Distance& second, double blend);

}  // namespace ease
