#include "collision/body/limb.h"

#include <algorithm>
#include <cmath>

namespace ease {

Limb taperedLimb(const Vec3& a, const Vec3& b, double radius_a, double radius_b, const Vec3& thin, double q) {
  Limb limb;
  limb.a = a;
  limb.radius_a = radius_a;
  limb.thin = thin;
  limb.excess = 1.0 / q - 1.0;
  const Vec3 axis = b - a + limb.excess * thin.dot(b - a) * thin;
  limb.length = axis.norm();
  limb.direction = axis / limb.length;
  limb.sine = (radius_a - radius_b) / limb.length;
  limb.tangent = limb.sine / std::sqrt(1.0 - limb.sine * limb.sine);
  limb.middle = 0.5 * (a + b);
  limb.enclosing = 0.5 * (b - a).norm() + std::max(radius_a, radius_b);
  // Far from the limb, limbDistance() is about |S x|^2 / |S^2 x|, where S stretches space.  By Kantorovich's inequality
  // that is at least |x| times this ratio.
  limb.min_ratio = 2.0 * q / (1.0 + q * q);
  return limb;
}

Distance limbDistance(const Limb& limb, const Vec3& x) {
  const Vec3 off = x - limb.a;
  const Vec3 from_a = off + limb.excess * limb.thin.dot(off) * limb.thin;
  const double along = from_a.dot(limb.direction);
  const double across = std::sqrt(std::max(0.0, from_a.squaredNorm() - along * along));

  // The cone is a union of spheres.  The centre of the one nearest to x lies where the cone's normal through x meets
  // the axis.
  const double centre = std::clamp(along - across * limb.tangent, 0.0, limb.length);
  const double radius = limb.radius_a - limb.sine * centre;
  const Vec3 from_centre = from_a - centre * limb.direction;
  const double reach = from_centre.norm();
  if (reach == 0.0) return {-radius, Vec3::UnitY()};

  const Vec3 stretched = from_centre + limb.excess * limb.thin.dot(from_centre) * limb.thin;
  const double steepness = stretched.norm();  // multiplied by reach
  return {(reach - radius) * reach / steepness, stretched / steepness};
}

bool isFurther(const Limb& limb, const Vec3& x, double distance) {
  const double radius = std::max(0.0, distance) / limb.min_ratio + limb.enclosing;
  return (x - limb.middle).squaredNorm() > radius * radius;
}

Distance smoothUnion(const Distance& first, const Distance& second, double blend) {
  const bool first_is_nearer = first.value <= second.value;
  const Distance& near = first_is_nearer ? first : second;
  const Distance& far = first_is_nearer ? second : first;
  const double h = blend - (far.value - near.value);
  if (h <= 0.0) return near;
  const double share = 0.5 * h * h / (blend * blend);  // of the farther one, in the gradient
  return {near.value - h * h * h / (6.0 * blend * blend), (1.0 - share) * near.gradient + share * far.gradient};
}

Distance smoothIntersection(const Distance& first, const Distance& second, double blend) {
  const Distance joined = smoothUnion({-first.value, -first.gradient}, {-second.value, -second.gradient}, blend);
  return {-joined.value, -joined.gradient};
}

}  // namespace ease
