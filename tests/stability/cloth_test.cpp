// Scenes of cloth alone in which methods are known to fail.  Every method must come through without a position that is
// not finite and without an explosion: no vertex further away than the scene can explain.
#include <catch2/catch.hpp>

#include <cmath>

#include "solver/base/error.h"
#include "solver/step/time_step.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

const FindContacts kNoContacts = [](const Positions&, Contacts& contacts) { contacts.planes.clear(); };

Material cloth(double stiffness, double bending = 1e-6) {
  Material material;
  material.stretch_warp = material.stretch_weft = stiffness;
  material.shear = 0.25 * stiffness;
  material.bending = bending;
  return material;
}

MethodOptions anyMethod() {
  return {GENERATE(Method::bw1, Method::newton, Method::pd, Method::pd_lbfgs, Method::automatic)};
}

/// A cloth, some of its vertices pinned, and steps of one method.
struct Trial {
  TriangleMesh mesh;
  Cloth cloth;
  TimeStep step;
  State state;
  Pins pins;
  StepOptions options;

  Trial(const TriangleMesh& sheet, const Material& material, const MethodOptions& method)
      : mesh(sheet),
        cloth(mesh, Vec3(0.0, -1.0, 0.0), material),
        step(cloth, method, systemOrdering(cloth.vertexCount(), cloth.triangles())),
        state{mesh.positions, Positions::Zero(mesh.positions.rows(), 3)} {}

  /// Pins vertex v where it is, moved by `shift`.
  void pin(int v, const Vec3& shift = Vec3::Zero()) {
    pins.vertices.push_back(v);
    pins.positions.push_back(mesh.positions.row(v).transpose() + shift);
  }

  /// So many steps; every position stays within `reach` (m) of the origin and every pin where it is put.
  void run(int steps, double reach) {
    for (int i = 0; i < steps; ++i) {
      step.step(state, options, pins, kNoContacts);
      REQUIRE(state.positions.allFinite());
      REQUIRE(state.positions.rowwise().norm().maxCoeff() < reach);
      for (size_t k = 0; k < pins.vertices.size(); ++k)
        REQUIRE((state.positions.row(pins.vertices[k]).transpose() - pins.positions[k]).norm() <= 1e-12);
    }
  }

  double membraneEnergy() {
    IncrementalPotential potential(cloth);
    StepOptions still;
    still.h = 1e9;
    still.gravity.setZero();
    potential.begin({state.positions, Positions::Zero(state.positions.rows(), 3)}, still);
    Positions gradient(state.positions.rows(), 3);
    return potential.gradient(state.positions, gradient);
  }

  Vec3 centreOfMass(const Positions& x) const {
    Vec3 sum = Vec3::Zero();
    double mass = 0.0;
    for (int i = 0; i < cloth.vertexCount(); ++i) {
      sum += cloth.masses()[i] * x.row(i).transpose();
      mass += cloth.masses()[i];
    }
    return sum / mass;
  }

  double kineticEnergy() const {
    double sum = 0.0;
    for (int i = 0; i < cloth.vertexCount(); ++i)
      sum += 0.5 * cloth.masses()[i] * state.velocities.row(i).squaredNorm();
    return sum;
  }
};

}  // namespace

TEST_CASE("a strip pressed together between pins folds, at any time step") {
  const double shortening = GENERATE(0.01, 0.05, 0.2), h = GENERATE(1.0 / 240.0, 1.0 / 30.0);
  Trial trial(makeSheet(16, 4, 0.2, 0.05, 0.1), cloth(500.0), anyMethod());
  trial.options.h = h;
  for (int j = 0; j <= 4; ++j) {
    trial.pin(17 * j);
    trial.pin(17 * j + 16, Vec3(-shortening * 0.2, 0.0, 0.0));
  }
  trial.run(30, 0.5);
}

TEST_CASE("a sheet pulled to three times its length at once comes to rest there") {
  const double h = GENERATE(1.0 / 30.0, 0.1, 0.5);
  Trial trial(makeSheet(10, 4, 0.2, 0.08), cloth(500.0), anyMethod());
  trial.options.h = h;
  for (int j = 0; j <= 4; ++j) {
    trial.pin(11 * j);
    trial.pin(11 * j + 10, Vec3(0.4, 0.0, 0.0));
  }
  trial.run(60, 1.0);
  CHECK(trial.state.velocities.rowwise().norm().maxCoeff() < 1.0);
}

TEST_CASE("cloth of any stiffness hangs from two corners") {
  const double stiffness = GENERATE(1e1, 1e2, 1e4, 1e6), h = GENERATE(1.0 / 960.0, 1.0 / 60.0, 0.2);
  Trial trial(makeSheet(10, 10, 0.3, 0.3, 0.1), cloth(stiffness), anyMethod());
  trial.options.h = h;
  trial.pin(110);
  trial.pin(120);
  // Softest: 0.15 kg/m^2 on 10 N/m stretches by 0.15 x 9.81 x 0.3 / 10, a twentieth, and by the corners' peaks.
  trial.run(30, 1.0);
}

TEST_CASE("slivers in the mesh do no harm") {
  const double aspect = GENERATE(1e2, 1e4, 1e6);
  TriangleMesh mesh = makeSheet(6, 6, 0.3, 0.3);
  for (int j = 0; j <= 6; ++j) mesh.positions(7 * j + 3, 0) = mesh.positions(7 * j + 2, 0) + 0.05 / aspect;
  Trial trial(mesh, cloth(500.0), anyMethod());
  trial.options.h = 1.0 / 60.0;
  trial.pin(42);
  trial.pin(48);
  trial.run(20, 1.0);
}

TEST_CASE("cloth collapsed to a line or to a point stays finite and opens") {
  const bool to_point = GENERATE(false, true);
  Trial trial(makeSheet(6, 6, 0.3, 0.3), cloth(500.0), anyMethod());
  trial.options.gravity.setZero();
  trial.state.positions.col(0).setConstant(0.1);
  if (to_point) trial.state.positions.col(1).setConstant(0.1);
  trial.run(40, 3.0);
}

TEST_CASE("masses of one to ten thousand go together") {
  TriangleMesh mesh = makeSheet(12, 4, 1.0, 0.1);
  for (int v = 0; v < mesh.positions.rows(); ++v)
    mesh.positions(v, 0) = 4e-5 * (std::pow(2.5e4, mesh.positions(v, 0)) - 1);
  Trial trial(mesh, cloth(500.0), anyMethod());
  const auto [least, most] = std::minmax_element(trial.cloth.masses().begin(), trial.cloth.masses().end());
  REQUIRE(*most > 1e4 * *least);
  trial.options.h = 1.0 / 60.0;
  for (int j = 0; j <= 4; ++j) trial.pin(13 * j + 12);
  trial.run(30, 3.0);
}

TEST_CASE("an endless time step finds the rest shape of free cloth") {
  const MethodOptions method = anyMethod();
  Trial trial(makeSheet(6, 6, 0.3, 0.3, 0.1), cloth(500.0), {method.method, 1e-3});
  trial.options.gravity.setZero();
  trial.options.h = 1e3;
  trial.state.positions.col(0) *= 1.1;
  const Vec3 centre = trial.centreOfMass(trial.state.positions);
  trial.run(10, 1.0);
  CHECK(trial.membraneEnergy() < 1e-6);
  CHECK((trial.centreOfMass(trial.state.positions) - centre).norm() < 1e-3);
  const Positions from_centre = trial.state.positions.rowwise() - trial.state.positions.colwise().mean();
  CHECK(from_centre.rowwise().norm().maxCoeff() < 0.25);
}

TEST_CASE("the centre of mass of free cloth falls as momentum says, however roughly a step is solved") {
  const MethodOptions method = anyMethod();
  Trial trial(makeSheet(6, 6, 0.3, 0.3, 0.1), cloth(500.0), {method.method, 0.5, 1e2, 1});
  trial.options.h = 1.0 / 60.0;
  trial.state.positions.col(0) *= 1.1;
  const Vec3 before = trial.centreOfMass(trial.state.positions);
  trial.run(1, 1.0);
  const Vec3 moved = trial.centreOfMass(trial.state.positions) - before;
  CHECK((moved - trial.options.h * trial.options.h * trial.options.gravity).norm() < 1e-13);
}

TEST_CASE("steps run to the minimum give free cloth no energy") {
  const Method method = GENERATE(Method::newton, Method::pd, Method::pd_lbfgs, Method::automatic);
  const double h = GENERATE(1.0 / 960.0, 1.0 / 60.0);
  Trial trial(makeSheet(8, 8, 0.3, 0.3, 0.1), cloth(500.0, 0.0), {method, 1e-6, 1e-6, 2000});
  trial.options.gravity.setZero();
  trial.options.h = h;
  trial.state.velocities = 0.5 * randomPositions(trial.cloth.vertexCount(), 3);
  double before = trial.kineticEnergy();
  for (int i = 0; i < 40; ++i) {
    trial.run(1, 2.0);
    const double after = trial.kineticEnergy() + trial.membraneEnergy();
    CHECK(after <= before * (1.0 + 1e-9));
    before = after;
  }
}
