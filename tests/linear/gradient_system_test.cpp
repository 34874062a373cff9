#include "solver/linear/gradient_system.h"

#include <catch2/catch.hpp>

#include "tests/differences.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

struct Flat {
  TriangleMesh mesh = makeSheet(8, 6, 0.4, 0.3, 0.25);
  std::vector<Mat2> rest_inverse;
  std::vector<double> areas;
  Flat() {
    for (int t = 0; t < mesh.triangles.rows(); ++t) {
      const Mat2 rest = edgeMatrix(mesh.positions, mesh.triangles, t).topRows<2>();
      rest_inverse.push_back(rest.inverse());
      areas.push_back(0.5 * rest.determinant());
    }
  }
  int vertices() const { return static_cast<int>(mesh.positions.rows()); }
};

}  // namespace

TEST_CASE("the gradient of a linear map is the map, on every triangle") {
  const Flat flat;
  Mat3 map;
  map << 1.1, 0.2, 0.0, -0.3, 0.8, 0.0, 0.4, 0.5, 1.0;
  const Positions x = flat.mesh.positions * map.transpose();
  for (int t = 0; t < flat.mesh.triangles.rows(); ++t) {
    const Mat32 b = shapeGradients(flat.rest_inverse[t]);
    Mat32 F = Mat32::Zero();
    for (int a = 0; a < 3; ++a) F += x.row(flat.mesh.triangles(t, a)).transpose() * b.row(a);
    CHECK((F - map.leftCols<2>()).norm() < 1e-12);
    CHECK((edgeMatrix(x, flat.mesh.triangles, t) * flat.rest_inverse[t] - F).norm() < 1e-12);
  }
}

TEST_CASE("gradients that a mesh can have are reproduced exactly, held by one vertex") {
  const Flat flat;
  const Positions expected = flat.mesh.positions + 0.05 * randomPositions(flat.vertices(), 11);
  std::vector<Mat32> targets;
  for (int t = 0; t < flat.mesh.triangles.rows(); ++t)
    targets.push_back(edgeMatrix(expected, flat.mesh.triangles, t) * flat.rest_inverse[t]);
  std::vector<double> diagonal(flat.vertices(), 0.0);
  diagonal[5] = 1.0;
  GradientSystem system(flat.vertices(), flat.mesh.triangles);
  REQUIRE(system.factor(flat.rest_inverse, flat.areas, diagonal));
  Positions x;
  system.solve(targets, expected, x);
  CHECK((x - expected).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("with targets that no mesh can have, no nearby positions do better") {
  const Flat flat;
  std::vector<Mat32> targets(flat.mesh.triangles.rows());
  const Positions noise = randomPositions(2 * static_cast<int>(targets.size()), 5);
  for (size_t t = 0; t < targets.size(); ++t) targets[t] = noise.middleRows<2>(2 * static_cast<int>(t)).transpose();
  const std::vector<double> diagonal(flat.vertices(), 0.3);
  const Positions anchors = randomPositions(flat.vertices(), 6);
  GradientSystem system(flat.vertices(), flat.mesh.triangles);
  REQUIRE(system.factor(flat.rest_inverse, flat.areas, diagonal));
  Positions x;
  system.solve(targets, anchors, x);
  const auto energy = [&](const Positions& at) {
    double e = 0.3 * (at - anchors).squaredNorm();
    for (size_t t = 0; t < targets.size(); ++t) {
      const int triangle = static_cast<int>(t);
      e += flat.areas[t] *
           (edgeMatrix(at, flat.mesh.triangles, triangle) * flat.rest_inverse[t] - targets[t]).squaredNorm();
    }
    return e;
  };
  const double least = energy(x);
  REQUIRE(least > 0.1);
  for (unsigned seed = 20; seed < 25; ++seed) {
    const Positions d = randomPositions(flat.vertices(), seed);
    CHECK(energy(x + 1e-3 * d) > least);
    CHECK(std::abs(difference([&](double e) { return energy(x + e * d); }, 1e-3)) < 1e-9);
  }
}

TEST_CASE("the matrix of a connected part without a diagonal term is not positive definite") {
  const Flat flat;
  GradientSystem system(flat.vertices(), flat.mesh.triangles);
  std::vector<double> diagonal(flat.vertices(), 0.0);
  diagonal[0] = -1.0;
  CHECK_FALSE(system.factor(flat.rest_inverse, flat.areas, diagonal));
}

TEST_CASE("a bond pulls two vertices to the difference that it asks for") {
  const Flat flat;
  std::vector<Mat32> targets;
  for (int t = 0; t < flat.mesh.triangles.rows(); ++t)
    targets.push_back(edgeMatrix(flat.mesh.positions, flat.mesh.triangles, t) * flat.rest_inverse[t]);
  std::vector<double> diagonal(flat.vertices(), 0.0);
  diagonal[0] = 1.0;
  const int p = flat.mesh.triangles(0, 0), q = flat.mesh.triangles(0, 1);
  const Vec3 asked(0.1, -0.2, 0.0);
  const auto differenceUnder = [&](double weight) -> Vec3 {
    GradientSystem system(flat.vertices(), flat.mesh.triangles);
    system.setBonds(std::vector<Bond>{{p, q, weight}});
    REQUIRE(system.factor(flat.rest_inverse, flat.areas, diagonal));
    Positions x;
    system.solve(targets, flat.mesh.positions, x, std::vector<Vec3>{asked});
    return x.row(p) - x.row(q);
  };
  CHECK((differenceUnder(1e9) - asked).norm() < 1e-6);
  CHECK((differenceUnder(1e-12) - Vec3(flat.mesh.positions.row(p) - flat.mesh.positions.row(q))).norm() < 1e-9);
}
