// Finds the closest point on one triangle, and whether it lies on a face, an edge or a vertex.
//
//            c
//           / \        vertex_k: corner k;  edge_k: the edge that starts at corner k
//   edge_2 /   \ edge_1
//         a-----b
//          edge_0
//
// Regions of the plane after Ericson, Real-Time Collision Detection (2005), section 5.1.5.
#pragma once

#include "solver/mesh/triangle_mesh.h"

namespace ease {

enum class Feature { face, edge_0, edge_1, edge_2, vertex_0, vertex_1, vertex_2 };

struct TrianglePoint {
  Vec3 point;
  Feature feature;
};

/// Finds the point of triangle (a, b, c) closest to x.  The triangle may be degenerate.
inline TrianglePoint closestOnTriangle(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto share = [](double part, double rest) { return part + rest > 0.0 ? part / (part + rest) : 0.0; };
  const Vec3 ab = b - a, ac = c - a, ax = x - a;
  const double ab_ax = ab.dot(ax), ac_ax = ac.dot(ax);
  if (ab_ax <= 0.0 && ac_ax <= 0.0) return {a, Feature::vertex_0};
  const Vec3 bx = x - b;
  const double ab_bx = ab.dot(bx), ac_bx = ac.dot(bx);
  if (ab_bx >= 0.0 && ac_bx <= ab_bx) return {b, Feature::vertex_1};
  const double weight_c = ab_ax * ac_bx - ab_bx * ac_ax;  // weights are multiplied by four times the squared area
  if (weight_c <= 0.0 && ab_ax >= 0.0 && ab_bx <= 0.0) return {a + share(ab_ax, -ab_bx) * ab, Feature::edge_0};
  const Vec3 cx = x - c;
  const double ab_cx = ab.dot(cx), ac_cx = ac.dot(cx);
  if (ac_cx >= 0.0 && ab_cx <= ac_cx) return {c, Feature::vertex_2};
  const double weight_b = ab_cx * ac_ax - ab_ax * ac_cx;
  if (weight_b <= 0.0 && ac_ax >= 0.0 && ac_cx <= 0.0) return {a + share(ac_ax, -ac_cx) * ac, Feature::edge_2};
  const double weight_a = ab_bx * ac_cx - ab_cx * ac_bx;
  const double along_bc = ac_bx - ab_bx, back_bc = ab_cx - ac_cx;
  if (weight_a <= 0.0 && along_bc >= 0.0 && back_bc >= 0.0)
    return {b + share(along_bc, back_bc) * (c - b), Feature::edge_1};
  const double scale = 1.0 / (weight_a + weight_b + weight_c);
  return {a + (weight_b * scale) * ab + (weight_c * scale) * ac, Feature::face};
}

}  // namespace ease
