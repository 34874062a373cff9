// Sheets and strips at rest whose shape and forces are known.
#include <catch2/catch.hpp>

#include "tests/accuracy/convergence.h"
#include "tests/accuracy/equilibrium.h"
#include "tests/accuracy/meshes.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

Material isotropicCloth(double mu, double lambda) {
  Material material;
  material.membrane = Membrane::isotropic;
  material.mu = mu;
  material.lambda = lambda;
  return material;
}

// Deflection of a square membrane of side 1 under unit load and unit tension, held at its edges.
double squareMembrane(double x, double y) {
  double w = 0.0;
  for (int m = 1; m < 60; m += 2)
    for (int n = 1; n < 60; n += 2)
      w += 16.0 / (std::pow(M_PI, 4) * m * n * (m * m + n * n)) * std::sin(m * M_PI * x) * std::sin(n * M_PI * y);
  return w;
}

struct Pull {
  double along, across;  // stretches
  bool held_sides;       // the sides are held too, not only the ends
};

// An irregular sheet of 0.3 m x 0.2 m held at these stretches, at rest.
Positions pulled(const Cloth& cloth, Method method, const Pull& pull) {
  Positions affine = cloth.restPositions();
  affine.col(0) *= pull.along;
  affine.col(1) *= pull.across;
  const std::vector<char> boundary = onBoundary(cloth);
  const Pins pins = pinsWhere(affine, [&](int i) {
    const double x = cloth.restPositions()(i, 0);
    return x < 1e-9 || x > 0.3 - 1e-9 || (pull.held_sides && boundary[i]);
  });
  State state = atRest(affine + 2e-3 * randomPositions(cloth.vertexCount(), 5));
  TimeStep step = makeStep(cloth, tight(method));
  REQUIRE(settle(step, state, {{1.0, Vec3::Zero()}, pins, 1e-11}));
  CHECK((state.positions - affine).cwiseAbs().maxCoeff() < 1e-10);
  return state.positions;
}

double pullAtEnd(const Cloth& cloth, const Positions& x) {
  const Positions forces = internalForces(cloth, x);
  double force = 0.0;
  for (int i = 0; i < x.rows(); ++i)
    if (cloth.restPositions()(i, 0) > 0.3 - 1e-9) force -= forces(i, 0);
  return force;
}

}  // namespace

TEST_CASE("pulled along one direction, an isotropic membrane narrows by its Poisson ratio and resists by its modulus") {
  const Method method = GENERATE(Method::newton, Method::pd_lbfgs);
  const double mu = 400.0, lambda = 300.0, strain = 0.08;
  const double modulus = 4.0 * mu * (mu + lambda) / (2.0 * mu + lambda), nu = lambda / (2.0 * mu + lambda);
  const Cloth cloth(makeSheet(7, 6, 0.3, 0.2, 0.3), Vec3(0.3, -1.0, 0.0), isotropicCloth(mu, lambda));
  const Positions x = pulled(cloth, method, {1.0 + strain, 1.0 - nu * strain, false});
  CHECK(pullAtEnd(cloth, x) == Approx(modulus * strain * 0.2).epsilon(1e-10));
}

TEST_CASE("pulled evenly in both directions, an isotropic membrane resists by 2 (mu + lambda)") {
  const Method method = GENERATE(Method::newton, Method::pd_lbfgs);
  const double mu = 400.0, lambda = 300.0, strain = 0.08;
  const Cloth cloth(makeSheet(7, 6, 0.3, 0.2, 0.3), Vec3(0.3, -1.0, 0.0), isotropicCloth(mu, lambda));
  const Positions x = pulled(cloth, method, {1.0 + strain, 1.0 + strain, true});
  CHECK(pullAtEnd(cloth, x) == Approx(2.0 * (mu + lambda) * strain * 0.2).epsilon(1e-10));
}

TEST_CASE("a strip without Poisson ratio stretches by its own weight as rho g/E (L X - X^2/2)") {
  const Method method = GENERATE(Method::newton, Method::pd_lbfgs, Method::automatic);
  const Membrane membrane = GENERATE(Membrane::woven, Membrane::isotropic);
  const double length = 0.5, modulus = 40.0;
  TriangleMesh mesh = makeGrid(4, 20, 0.1, length);
  mesh.positions.col(1) *= -1.0;  // down
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  Material material = isotropicCloth(0.5 * modulus, 0.0);
  material.membrane = membrane;
  material.stretch_warp = material.stretch_weft = modulus;
  material.shear = 0.25 * modulus;
  const Cloth cloth(mesh, -Vec3::UnitY(), material);
  State state = atRest(mesh.positions);
  TimeStep step = makeStep(cloth, tight(method));
  const Pins pins = pinsWhere(mesh.positions, [&](int i) { return mesh.positions(i, 1) > -1e-9; });
  REQUIRE(settle(step, state, {{1.0}, pins, 1e-9}));
  const double load = material.density * 9.81 / modulus;  // 1/m
  const int n = 4;
  for (int j = 0; j <= 20; ++j) {
    const double X = j * length / 20.0, expected = load * (length * X - 0.5 * X * X);
    const auto fall = [&](int i) { return -state.positions(j * (n + 1) + i, 1) - X; };
    // The lumped masses of the two lower corners are not those of their cells, so that these hang askew.
    const double mean = (0.5 * fall(0) + fall(1) + fall(2) + fall(3) + 0.5 * fall(4)) / n;
    CHECK(mean == Approx(expected).margin(1e-3 * 0.5 * load * length * length));
    for (int i = 0; i <= n; ++i) CHECK(fall(i) == Approx(expected).margin(1e-2 * 0.5 * load * length * length));
  }
}

TEST_CASE("the deflection of a taut sheet converges by the square of the mesh size, also on irregular meshes") {
  const Method method = GENERATE(Method::newton, Method::pd_lbfgs);
  const double jitter = GENERATE(0.0, 0.2);
  const double stretch = 1.1, gravity = 0.5;
  Material material;
  material.stretch_warp = material.stretch_weft = 200.0;
  const double tension = material.stretch_warp * (stretch - 1.0) / stretch;  // against a slope by rest length, N/m
  std::vector<double> sizes, errors;
  for (int n : {4, 8, 16, 32}) {
    const TriangleMesh mesh = makeSheet(n, n, 1.0, 1.0, jitter);
    const Cloth cloth(mesh, Vec3::UnitY(), material);
    const std::vector<char> boundary = onBoundary(cloth);
    State state = atRest(stretch * mesh.positions);
    const Pins pins = pinsWhere(state.positions, [&](int i) { return boundary[i] != 0; });
    TimeStep step = makeStep(cloth, {method, 1e-7, 1e-7});
    REQUIRE(settle(step, state, {{30.0, {0.0, 0.0, gravity}}, pins, 1e-8}));
    double squared = 0.0, scale = 0.0;
    for (int i = 0; i < mesh.positions.rows(); ++i) {
      const double w =
          material.density * gravity / tension * squareMembrane(mesh.positions(i, 0), mesh.positions(i, 1));
      squared += cloth.masses()[i] * std::pow(state.positions(i, 2) - w, 2);
      scale += cloth.masses()[i] * w * w;
    }
    sizes.push_back(1.0 / n);
    errors.push_back(std::sqrt(squared / scale));
  }
  INFO("relative errors " << errors[0] << ", " << errors[1] << ", " << errors[2] << ", " << errors[3]);
  CHECK(errors.back() < 0.01);
  CHECK(fittedOrder(sizes, errors) == Approx(2.0).margin(0.2));
}
