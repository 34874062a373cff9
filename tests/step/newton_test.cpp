#include "solver/step/newton.h"

#include <oneapi/tbb/task_arena.h>

#include <catch2/catch.hpp>

#include "solver/mesh/error.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

const FindContacts kNoContacts = [](const Positions&, std::vector<ContactPlane>& planes) { planes.clear(); };

Material softCloth() {
  Material material;
  material.stretch_warp = material.stretch_weft = 200.0;
  material.shear = 50.0;
  material.bending = 1e-5;
  return material;
}

State atRest(const TriangleMesh& mesh) {
  return {mesh.positions, Positions::Zero(mesh.positions.rows(), 3)};
}

// Floor at y = 0, for the vertices of a cloth.
FindContacts floorFor(const Cloth& cloth) {
  return [&cloth](const Positions& x, std::vector<ContactPlane>& planes) {
    planes.assign(x.rows() + cloth.topology().edges.size() + cloth.triangleCount(), {});
    for (int i = 0; i < x.rows(); ++i) planes[i] = {Vec3::UnitY(), 0.0};
  };
}

}  // namespace

TEST_CASE("free fall is what backward Euler makes of it") {
  const TriangleMesh mesh = makeSheet(6, 6, 0.2, 0.2);
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), softCloth());
  NewtonStep newton(cloth);
  State state = atRest(mesh);
  const Vec3 v0(0.3, 0.5, -0.1);
  state.velocities.rowwise() += v0.transpose();
  const StepOptions options;
  const int n = 40;
  for (int i = 0; i < n; ++i) newton.step(state, options, {}, kNoContacts);
  const Vec3 moved = n * options.h * v0 + 0.5 * options.gravity * options.h * options.h * n * (n + 1);
  Positions expected = mesh.positions;
  expected.rowwise() += moved.transpose();
  CHECK((state.positions - expected).cwiseAbs().maxCoeff() < 1e-8);  // linear systems are solved to 1 %
}

TEST_CASE("pinned vertices are where they were told to be, exactly, and may be changed") {
  const TriangleMesh mesh = makeSheet(8, 8, 0.3, 0.3);
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), softCloth());
  NewtonStep newton(cloth);
  State state = atRest(mesh);
  Pins pins{{0, 8}, {mesh.positions.row(0), mesh.positions.row(8)}};
  for (int i = 0; i < 20; ++i) {
    if (i == 10) pins = {{0, 8, 40}, {Vec3(0.0, 0.01, 0.0), Vec3(0.3, 0.01, 0.0), Vec3(0.15, 0.1, 0.02)}};
    newton.step(state, {}, pins, kNoContacts);
    for (size_t k = 0; k < pins.vertices.size(); ++k)
      CHECK((state.positions.row(pins.vertices[k]).transpose() - pins.positions[k]).norm() == 0.0);
  }
  CHECK(state.positions.col(1).minCoeff() < mesh.positions.col(1).minCoeff() - 1e-3);
}

TEST_CASE("a hanging strip stretches by its own weight as it should") {
  // Zero Poisson ratio: u(X) = rho g / k (L X - X^2/2); the weft is free, shear does nothing.
  const double length = 0.5, width = 0.1;
  TriangleMesh mesh = makeSheet(4, 20, width, length);
  mesh.positions.col(1) = mesh.positions.col(1).array() - length;  // top edge at y = 0, hanging down
  Material material = softCloth();
  material.bending = 0.0;
  material.damping_stretch = 5.0;
  material.damping_shear = 5.0;
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), material);
  NewtonStep newton(cloth);
  State state = atRest(mesh);
  Pins pins;
  for (int i = 0; i < mesh.positions.rows(); ++i)
    if (mesh.positions(i, 1) > -1e-9) {
      pins.vertices.push_back(i);
      pins.positions.push_back(mesh.positions.row(i));
    }
  StepOptions options;
  options.h = 0.05;
  for (int i = 0; i < 200; ++i) newton.step(state, options, pins, kNoContacts);
  REQUIRE(state.velocities.cwiseAbs().maxCoeff() < 1e-5);
  const double load = material.density * 9.81 / material.stretch_warp;
  for (int i = 0; i < mesh.positions.rows(); ++i) {
    const double X = -mesh.positions(i, 1);
    const double expected = load * (length * X - 0.5 * X * X);
    CHECK(-state.positions(i, 1) - X == Approx(expected).margin(0.01 * load * length * length));
  }
}

TEST_CASE("cloth dropped on a floor stays on it") {
  TriangleMesh mesh = makeSheet(6, 6, 0.2, 0.2);
  mesh.positions.col(2).swap(mesh.positions.col(1));
  mesh.positions.col(1).array() += 0.02;
  const Cloth cloth(mesh, Vec3(0.0, 0.0, -1.0), softCloth());
  NewtonStep newton(cloth);
  State state = atRest(mesh);
  for (int i = 0; i < 200; ++i) newton.step(state, {}, {}, floorFor(cloth));
  CHECK(state.positions.col(1).maxCoeff() < 1e-4);
  CHECK(state.positions.col(1).minCoeff() > -1e-4);
  CHECK(state.velocities.cwiseAbs().maxCoeff() < 0.02);
}

TEST_CASE("the same steps with one thread and with two, to the last bit") {
  const TriangleMesh mesh = makeSheet(40, 40, 0.5, 0.5);
  State states[2];
  for (int threads = 1; threads <= 2; ++threads) {
    tbb::task_arena arena(threads);
    arena.execute([&] {
      const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), softCloth());
      NewtonStep newton(cloth);
      State& state = states[threads - 1] = atRest(mesh);
      const Pins pins{{0, 40}, {mesh.positions.row(0), mesh.positions.row(40)}};
      for (int i = 0; i < 10; ++i) newton.step(state, {}, pins, kNoContacts);
    });
  }
  CHECK(states[0].positions == states[1].positions);
  CHECK(states[0].velocities == states[1].velocities);
  CHECK((states[0].positions - mesh.positions).norm() > 1e-3);
}

TEST_CASE("a state that is not finite is an error, and stays as it was") {
  const TriangleMesh mesh = makeSheet(4, 4, 0.2, 0.2);
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), softCloth());
  NewtonStep newton(cloth);
  State state = atRest(mesh);
  state.velocities(3, 1) = std::nan("");
  CHECK_THROWS_AS(newton.step(state, {}, {}, kNoContacts), ComputationError);
  CHECK(state.positions == mesh.positions);
}
