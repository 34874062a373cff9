#include "collision/body_pins.h"

#include <limits>

#include "collision/triangle_tree.h"
#include "solver/mesh/triangle_gradient.h"

namespace ease {

namespace {

/// Columns: the two edges from corner a, and the unit normal.
Mat3 triangleBasis(const Vec3& a, const Vec3& b, const Vec3& c) {
  Mat3 basis;
  basis << b - a, c - a, (b - a).cross(c - a).normalized();
  return basis;
}

}  // namespace

std::vector<BodyTie> tieToBody(const std::vector<int>& vertices, const Positions& x, const Positions& body,
                               const Triangles& triangles) {
  if (vertices.empty()) return {};
  const TriangleTree tree(body, triangles);
  std::vector<BodyTie> ties;
  for (int v : vertices) {
    const Vec3 point = x.row(v);
    const int t = tree.closest(point, std::numeric_limits<double>::infinity()).triangle;
    const Vec3 a = body.row(triangles(t, 0));
    const Mat3 basis = triangleBasis(a, body.row(triangles(t, 1)), body.row(triangles(t, 2)));
    ties.push_back({t, basis.inverse() * (point - a)});
  }
  return ties;
}

Vec3 placeOf(const BodyTie& tie, const BodyMoment& body) {
  const auto corners = body.triangles->row(tie.triangle);
  const Vec3 a = body.position(corners[0]);
  return a + triangleBasis(a, body.position(corners[1]), body.position(corners[2])) * tie.local;
}

}  // namespace ease
