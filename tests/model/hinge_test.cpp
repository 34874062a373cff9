#include "solver/model/hinge.h"

#include <catch2/catch.hpp>
#include <numeric>

using namespace ease;

namespace {

/// Two triangles in the plane that share the edge from x0 to x1: all sides differ in length.
const Positions kFlat =
    (Positions(4, 3) << 0.0, 0.0, 0.0, 0.2, 0.03, 0.0, 0.07, 0.11, 0.0, 0.12, -0.05, 0.0).finished();
const std::array<int, 4> kVertices = {0, 1, 2, 3};

Mat2 edges(const Positions& x, int a, int b, int c) {
  Mat2 D;
  D.col(0) = (x.row(b) - x.row(a)).head<2>();
  D.col(1) = (x.row(c) - x.row(a)).head<2>();
  return D;
}

Hinge flatHinge() {
  return makeHinge(kVertices, edges(kFlat, 0, 1, 2), edges(kFlat, 1, 0, 3));
}

}  // namespace

TEST_CASE("a hinge folded by an angle has a vector of twice its edge's length times the sine of half the angle") {
  const Hinge hinge = flatHinge();
  const Vec3 edge = (kFlat.row(1) - kFlat.row(0)).transpose();
  for (const double angle : {0.0, 1e-3, 0.5, 2.0, M_PI}) {
    Positions folded = kFlat;
    folded.row(3) = (Eigen::AngleAxisd(angle, edge.normalized()) * Vec3(kFlat.row(3))).transpose();  // about x0
    CHECK(hingeVector(hinge, folded).norm() == Approx(2.0 * edge.norm() * std::sin(0.5 * angle)).margin(1e-15));
  }
}

TEST_CASE("a hinge that stays flat has no vector, however its plane is turned or stretched") {
  const Hinge hinge = flatHinge();
  CHECK(std::abs(std::accumulate(hinge.stencil.begin(), hinge.stencil.end(), 0.0)) < 1e-14);
  Mat3 map;
  map << 1.2, 0.3, 0.0, -0.2, 0.9, 0.0, 0.5, 0.1, 1.0;
  Positions moved = kFlat * map.transpose();
  moved.rowwise() += Eigen::RowVector3d(0.3, -0.1, 0.2);
  CHECK(hingeVector(hinge, moved).norm() < 1e-15);
}

TEST_CASE("a hinge does not depend on the frames of its triangles' edges, turned or mirrored") {
  const Mat2 first = edges(kFlat, 0, 1, 2), second = edges(kFlat, 1, 0, 3);
  const Mat2 turn = Eigen::Rotation2Dd(0.8).toRotationMatrix();
  Mat2 mirror = turn;
  mirror.col(0) *= -1.0;
  const Hinge plain = makeHinge(kVertices, first, second), turned = makeHinge(kVertices, turn * first, mirror * second);
  for (int i = 0; i < 4; ++i) CHECK(turned.stencil[i] == Approx(plain.stencil[i]).epsilon(1e-13));
  CHECK(turned.inverse_area == Approx(plain.inverse_area).epsilon(1e-13));
  CHECK(plain.vertices == kVertices);
}

TEST_CASE("a hinge of twice the size has the same stencil and four times the area") {
  const Mat2 first = edges(kFlat, 0, 1, 2), second = edges(kFlat, 1, 0, 3);
  const Hinge plain = flatHinge(), large = makeHinge(kVertices, 2.0 * first, 2.0 * second);
  for (int i = 0; i < 4; ++i) CHECK(large.stencil[i] == Approx(plain.stencil[i]).epsilon(1e-14));
  CHECK(plain.inverse_area == Approx(2.0 / (std::abs(first.determinant()) + std::abs(second.determinant()))));
  CHECK(large.inverse_area == Approx(0.25 * plain.inverse_area));
}
