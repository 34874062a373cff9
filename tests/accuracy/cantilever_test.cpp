// A strip clamped at one end droops under its own weight along the master curve of Romero et al., Physical validation
// of simulators in computer graphics, 2021.
//
//   Gamma = rho g L^3/D   rho  kg/m^2, g  m/s^2, L  length, m, D  bending stiffness, N m
//   H/W                   drop over reach of the free end
//
// On equilateral triangles hinges are an isotropic plate of stiffness D (and Poisson ratio -1/3, which a stiff membrane
// does not let show).  Along free edges hinges are missing: a strip of n triangles across is softer by a part that goes
// as 1/n, so that two widths tell what infinitely many would do.
#include <catch2/catch.hpp>

#include "tests/accuracy/equilibrium.h"
#include "tests/accuracy/meshes.h"

using namespace ease;

namespace {

// Drop over reach of a strip along x, 1 m long, of equilateral triangles: `rows` along, `across` across.  Its first row
// of triangles is held: the strip is horizontal at the middle of these, which is where its length starts.
double dropOverReach(int across, int rows, double gamma, double membrane, Method method) {
  const double row = 1.0 / (rows - 0.5);
  const TriangleMesh mesh = makeEquilateral(across, rows, 2.0 * row / std::sqrt(3.0));
  Material material;
  material.density = 0.1;
  const double weight = material.density * 9.81;  // N/m^2
  material.bending = weight / gamma;
  material.stretch_warp = material.stretch_weft = membrane * std::max(weight, 0.03 * material.bending / (row * row));
  material.shear = 0.5 * material.stretch_warp;
  const Cloth cloth(mesh, Vec3::UnitX(), material);
  State state = atRest(mesh.positions);
  const Pins pins = pinsWhere(mesh.positions, [&](int i) { return i / (across + 1) < 2; });
  TimeStep step = makeStep(cloth, {method, 1e-6, 1e-3});
  REQUIRE(settle(step, state, {{0.3, {0.0, 0.0, -9.81}}, pins, 1e-6, 300}));
  const Vec3 tip = state.positions.bottomRows(across + 1).colwise().mean();
  return -tip[2] / (tip[0] - 0.5 * row);
}

struct Droop {
  Method method;
  double gamma, expected;
  int rows;
  double membrane;  // stiffness, times the larger of what weight and bending ask for: 1e-3 of strain, or less
};

}  // namespace

TEST_CASE("a clamped strip droops along the master curve") {
  const Droop droop =
      GENERATE(Droop{Method::pd_lbfgs, 1.0, 0.12456, 24, 1e5}, Droop{Method::pd_lbfgs, 3.0, 0.36462, 24, 1e5},
               Droop{Method::pd_lbfgs, 10.0, 1.0668, 24, 1e3}, Droop{Method::pd_lbfgs, 30.0, 2.5472, 24, 1e4},
               Droop{Method::pd_lbfgs, 100.0, 5.8881, 32, 1e3}, Droop{Method::pd_lbfgs, 300.0, 11.183, 64, 1e3},
               Droop{Method::pd_lbfgs, 1000.0, 21.335, 96, 1e3}, Droop{Method::newton, 10.0, 1.0668, 24, 1e3},
               Droop{Method::newton, 100.0, 5.8881, 32, 1e3}, Droop{Method::newton, 300.0, 11.183, 48, 1e3});
#ifdef __SANITIZE_THREAD__
  if (droop.rows > 24) return;  // the same loops as the others', for a quarter of an hour
#endif
  const double narrow = dropOverReach(4, droop.rows, droop.gamma, droop.membrane, droop.method);
  const double wide = dropOverReach(8, droop.rows, droop.gamma, droop.membrane, droop.method);
  INFO("gamma " << droop.gamma << ", 4 and 8 triangles across: " << narrow << ", " << wide);
  CHECK(2.0 * wide - narrow == Approx(droop.expected).epsilon(0.01));
}
