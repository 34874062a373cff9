#include "collision/body_pins.h"

#include <limits>

#include "solver/mesh/triangle_gradient.h"

namespace ease {

namespace {

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
  const auto vertex = [&](int v) -> Vec3 {
    return (1.0 - body.tau) * body.at->row(v) + body.tau * body.towards->row(v);
  };
  const auto corners = body.triangles->row(tie.triangle);
  const Vec3 a = vertex(corners[0]);
  return a + triangleBasis(a, vertex(corners[1]), vertex(corners[2])) * tie.local;
}

}  // namespace ease
