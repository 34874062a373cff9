// A sphere of isotropic membrane under pressure.
//
//   s   stretch     R0   radius at rest, m     p = 4 (mu + lambda) (s - 1)/(R0 s^2)   pressure, Pa
//
// Pressure follows the surface and is no term of the potential: it is a load found anew from where the cloth is, until
// it is the one that holds it there.
#include <catch2/catch.hpp>

#include "tests/accuracy/convergence.h"
#include "tests/accuracy/equilibrium.h"
#include "tests/accuracy/meshes.h"

using namespace ease;

namespace {

Positions pressureForces(const Triangles& triangles, const Positions& x, double pressure) {
  Positions forces = Positions::Zero(x.rows(), 3);
  for (int t = 0; t < triangles.rows(); ++t) {
    const Vec3 a = x.row(triangles(t, 0)), b = x.row(triangles(t, 1)), c = x.row(triangles(t, 2));
    for (int corner = 0; corner < 3; ++corner)
      forces.row(triangles(t, corner)) += pressure / 6.0 * doubleAreaNormal(a, b, c);
  }
  return forces;
}

}  // namespace

TEST_CASE("a sphere inflated by a pressure is as large as its membrane lets it be") {
  const Method method = GENERATE(Method::newton, Method::pd_lbfgs);
  const double radius = 0.1, stretch = 1.2;
  Material material;
  material.membrane = Membrane::isotropic;
  material.mu = 400.0;
  material.lambda = 300.0;
  const auto pressureAt = [&](double s) {
    return 4.0 * (material.mu + material.lambda) * (s - 1.0) / (radius * s * s);
  };
  const double pressure = pressureAt(stretch);
  std::vector<double> sizes, errors;
  for (int divisions : {1, 2, 3}) {
    const TriangleMesh mesh = makeSphere(divisions, radius);
    const Cloth cloth(mesh, Vec3(0.31, -1.0, 0.17), material);
    State state = atRest(mesh.positions);
    TimeStep step = makeStep(cloth, {method, 1e-8, 1e-4});
    const Load load = [&](const Positions& x) { return pressureForces(mesh.triangles, x, pressure); };
    REQUIRE(settle(step, state, {{0.02, Vec3::Zero()}, {}, 1e-7, 100, load}));
    const Positions from_centre = state.positions.rowwise() - state.positions.colwise().mean();
    const double mean = from_centre.rowwise().norm().mean();
    CHECK(from_centre.rowwise().norm().maxCoeff() < 1.01 * mean);
    sizes.push_back(std::pow(0.5, divisions));
    errors.push_back(std::abs(pressureAt(mean / radius) / pressure - 1.0));
  }
  INFO("relative errors of pressure " << errors[0] << ", " << errors[1] << ", " << errors[2]);
  CHECK(errors.back() < 0.005);
  CHECK(fittedOrder(sizes, errors) == Approx(2.0).margin(0.2));
}
