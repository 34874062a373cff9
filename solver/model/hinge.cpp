#include "solver/model/hinge.h"

#include <cmath>

namespace ease {

namespace {

/// Cotangents of the angles at corners 0 and 1 of a flat triangle with edges D.
std::array<double, 2> cotangents(const Mat2& D) {
  const Eigen::Vector2d e = D.col(0), f = D.col(1);
  const double double_area = std::abs(D.determinant());
  return {e.dot(f) / double_area, e.dot(e - f) / double_area};
}

}  // namespace

Hinge makeHinge(const std::array<int, 4>& vertices, const Mat2& first, const Mat2& second) {
  const auto [at0, at1] = cotangents(first);  // corners x0, x1
  const auto [second_at1, second_at0] = cotangents(second);
  Hinge hinge;
  hinge.vertices = vertices;
  hinge.stencil = {at1 + second_at1, at0 + second_at0, -at0 - at1, -second_at0 - second_at1};
  hinge.inverse_area = 2.0 / (std::abs(first.determinant()) + std::abs(second.determinant()));
  return hinge;
}

Vec3 hingeVector(const Hinge& hinge, const Positions& x) {
  Vec3 b = Vec3::Zero();
  for (int i = 0; i < 4; ++i) b += hinge.stencil[i] * x.row(hinge.vertices[i]).transpose();
  return b;
}

}  // namespace ease
