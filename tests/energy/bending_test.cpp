#include "solver/energy/bending.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "solver/model/cloth.h"
#include "tests/differences.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

Cloth bendingCloth(const TriangleMesh& mesh, double bending) {
  Material material;
  material.bending = bending;
  return Cloth(mesh, Vec3(0.0, -1.0, 0.0), material);
}

double energyOf(const Cloth& cloth, const Positions& x) {
  double energy = 0.0;
  for (const Hinge& hinge : cloth.hinges())
    energy += 0.5 * cloth.material().bending * hinge.inverse_area * hingeVector(hinge, x).squaredNorm();
  return energy;
}

/// A parallelogram of equilateral triangles, with n by m edges of length `edge`, m.
TriangleMesh equilateralSheet(int n, int m, double edge) {
  TriangleMesh sheet = makeSheet(n, m, 1.0, 1.0);
  const double row = edge * std::sqrt(3.0) / 2.0;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) sheet.positions.row(j * (n + 1) + i) << edge * (i - 0.5 * j), row * j, 0.0;
  int t = 0;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      sheet.triangles.row(t++) << a, b, d;
      sheet.triangles.row(t++) << a, d, c;
    }
  return sheet;
}

Vec3 gradientOf(const HingeDamper<double>& damper, const Vec3& b) {
  return damper.weight(b.norm()) * b;
}

}  // namespace

TEST_CASE("a flat sheet of any triangles, however turned and stretched in its plane, does not bend") {
  const TriangleMesh mesh = makeSheet(6, 5, 0.3, 0.2, 0.3);
  const Cloth cloth = bendingCloth(mesh, 1e-3);
  REQUIRE(cloth.hinges().size() > 50);
  Mat3 map;
  map << 1.2, 0.3, 0.0, -0.2, 0.9, 0.0, 0.5, 0.1, 1.0;
  CHECK(energyOf(cloth, mesh.positions * map.transpose()) < 1e-25);
}

TEST_CASE("a sheet rolled to a cylinder has the energy of its curvature") {
  // The energy is 1/2 D kappa^2 per area for any direction of rolling, if the triangles are equilateral. The tolerance
  // allows for the boundary, whose edges have no hinge.
  const double D = 2e-3, radius = 1.0;
  const TriangleMesh mesh = equilateralSheet(60, 60, 0.01);
  const Cloth cloth = bendingCloth(mesh, D);
  double area = 0.0;
  for (double a : cloth.restAreas()) area += a;
  for (const double angle : {0.0, 0.4, M_PI / 2.0}) {
    Positions x(mesh.positions.rows(), 3);
    for (int i = 0; i < x.rows(); ++i) {
      const double u = std::cos(angle) * mesh.positions(i, 0) + std::sin(angle) * mesh.positions(i, 1);
      const double v = -std::sin(angle) * mesh.positions(i, 0) + std::cos(angle) * mesh.positions(i, 1);
      x.row(i) << radius * std::sin(u / radius), v, radius * std::cos(u / radius);
    }
    CHECK(energyOf(cloth, x) == Approx(0.5 * D / (radius * radius) * area).epsilon(0.04));
  }
}

TEST_CASE("bending's damping has derivatives that are derivatives, whether it bends or unbends") {
  const Vec3 b(0.5, -0.2, 0.3), d(0.4, 0.5, -0.3);
  for (const double start : {0.4, 0.9}) {
    const HingeDamper<double> damper{0.3, start};
    const Vec3 gradient = gradientOf(damper, b);
    const Mat3 hessian = hingeDampingHessian(b, damper, HessianKind::exact);
    REQUIRE(gradient.norm() > 1e-3);
    for (int i = 0; i < 3; ++i) {
      const auto energy = [&](double e) { return damper.energy((b + e * Vec3::Unit(i)).norm()); };
      const auto force = [&](double e) { return gradientOf(damper, b + e * Vec3::Unit(i)); };
      CHECK(std::abs(sharpDifference(energy, 4e-3) - gradient[i]) < 1e-9 * gradient.norm());
      CHECK((sharpDifference(force, 4e-3) - hessian.col(i)).norm() < 1e-9 * hessian.norm());
    }
    const auto energy = [&](double e) { return damper.energy((b + e * d).norm()); };
    const auto force = [&](double e) { return gradientOf(damper, b + e * d); };
    CHECK(orderOfDifference(energy, gradient.dot(d), 0.02) == Approx(2.0).margin(0.1));
    CHECK(orderOfDifference(force, Vec3(hessian * d), 0.02) == Approx(2.0).margin(0.1));
  }
}

TEST_CASE("turning a bent hinge as a whole is not damped") {
  const Vec3 b(0.5, -0.2, 0.3);
  const Vec3 turned = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, 3.0).normalized()) * b;
  CHECK(gradientOf({0.3, b.norm()}, turned).norm() < 1e-12);
  CHECK(gradientOf({0.3, 0.1}, Vec3::Zero()) == Vec3::Zero());
}
