// What backward Euler does to motion in time.
#include <catch2/catch.hpp>

#include "tests/accuracy/convergence.h"
#include "tests/accuracy/equilibrium.h"
#include "tests/accuracy/meshes.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

double warpEnergy(const Cloth& cloth, const Positions& x) {
  double energy = 0.0;
  for (int t = 0; t < cloth.triangleCount(); ++t)
    energy += 0.5 * cloth.material().stretch_warp * cloth.restAreas()[t] *
              std::pow(cloth.deformation(x, t).col(0).norm() - 1.0, 2);
  return energy;
}

double kineticEnergy(const Cloth& cloth, const Positions& v) {
  double energy = 0.0;
  for (int i = 0; i < v.rows(); ++i) energy += 0.5 * cloth.masses()[i] * v.row(i).squaredNorm();
  return energy;
}

}  // namespace

TEST_CASE("a mode of a strip stretched along its warp loses energy by exactly 1/(1 + w^2 h^2) a step") {
  // Springs along the warp alone are linear as long as nothing moves sideways, and sines are modes of equal cells:
  // w = 2/dx sqrt(k/rho) sin(pi p / 2N).
  const Method method = GENERATE(Method::newton, Method::pd, Method::pd_lbfgs, Method::automatic);
  const double h = GENERATE(0.0025, 0.02);  // s: w h = 0.4 and 3
  const int cells = 12, mode = 2;
  const double length = 0.8, dx = length / cells;
  const TriangleMesh mesh = makeGrid(cells, 2, length, 0.2);
  Material material;
  material.stretch_warp = 200.0;
  material.stretch_weft = material.shear = 0.0;
  const Cloth cloth(mesh, Vec3::UnitX(), material);
  const double phase = 0.5 * M_PI * mode / cells;
  const double omega = 2.0 / dx * std::sqrt(material.stretch_warp / material.density) * std::sin(phase);

  State state = atRest(mesh.positions);
  for (int i = 0; i < mesh.positions.rows(); ++i) {
    const double shape = std::sin(mode * M_PI * mesh.positions(i, 0) / length);
    state.positions(i, 0) += 1e-3 * shape;
    state.velocities(i, 0) = 0.2 * shape;
  }
  const Pins pins = pinsWhere(mesh.positions, [&](int i) {
    const double x = mesh.positions(i, 0);
    return x < 1e-9 || x > length - 1e-9;
  });
  StepOptions options;
  options.h = h;
  options.gravity.setZero();
  TimeStep step = makeStep(cloth, tight(method));
  double energy = warpEnergy(cloth, state.positions) + kineticEnergy(cloth, state.velocities);
  REQUIRE(energy > 1e-6);
  // Positions near 0.8 m are rounded to 1e-16 m: once the mode moves by less than 1e-6 m in a step, that alone changes
  // its energy by 1e-10.
  const double smallest = 1e-5 * energy;
  for (int n = 0; n < 5 && energy > smallest; ++n) {
    step.step(state, options, pins, kNoContacts);
    const double after = warpEnergy(cloth, state.positions) + kineticEnergy(cloth, state.velocities);
    CHECK(after / energy == Approx(1.0 / (1.0 + omega * omega * h * h)).epsilon(1e-10));
    energy = after;
  }
}

TEST_CASE("backward Euler's error is of first order in the time step") {
  // A taut sheet set going; each trajectory is compared with that of half its time step.
  const Method method = GENERATE(Method::bw1, Method::newton, Method::pd, Method::pd_lbfgs, Method::automatic);
  const TriangleMesh mesh = makeSheet(8, 8, 0.3, 0.3);
  Material material;
  material.stretch_warp = material.stretch_weft = 200.0;
  material.shear = 50.0;
  const Cloth cloth(mesh, Vec3::UnitY(), material);
  const std::vector<char> boundary = onBoundary(cloth);
  const Positions taut = 1.1 * mesh.positions;
  const Pins pins = pinsWhere(taut, [&](int i) { return boundary[i] != 0; });
  const double duration = 0.012;  // s: a quarter of the slowest oscillation
  std::vector<double> time_steps, errors;
  Positions coarser;
  for (int count : {40, 80, 160, 320}) {
    StepOptions options;
    options.h = duration / count;
    TimeStep step = makeStep(cloth, {method, 1e-7, 1e-7, 200});
    State state = atRest(taut);
    for (int i = 0; i < taut.rows(); ++i)
      state.velocities(i, 2) =
          std::sin(M_PI * mesh.positions(i, 0) / 0.3) * std::sin(M_PI * mesh.positions(i, 1) / 0.3);
    for (int n = 0; n < count; ++n) step.step(state, options, pins, kNoContacts);
    if (count > 40) {
      time_steps.push_back(options.h);
      errors.push_back((state.positions - coarser).norm());
    } else {
      REQUIRE((state.positions - taut).col(2).maxCoeff() > 1e-3);
    }
    coarser = state.positions;
  }
  CHECK(fittedOrder(time_steps, errors) == Approx(1.0).margin(0.1));
}
