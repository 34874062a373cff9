#include "solver/step/time_step.h"

#include <oneapi/tbb/task_arena.h>

#include <catch2/catch.hpp>

#include "solver/base/error.h"
#include "tests/step/soft_sheet.h"

using namespace ease;

namespace {

MethodOptions tight(Method method) {
  return {method, 1e-9, 1e-9, 3000};
}

/// Finds contacts of the cloth's vertices with a floor at y = 0.
FindContacts floorFor(const Cloth& cloth) {
  return [&cloth](const Positions& x, Contacts& contacts) {
    contacts.planes.assign(x.rows() + cloth.topology().edges.size() + cloth.triangleCount(), {});
    for (int i = 0; i < x.rows(); ++i) contacts.planes[i] = {Vec3::UnitY(), 0.0};
  };
}

}  // namespace

TEST_CASE("free fall is what backward Euler makes of it") {
  const Method method = GENERATE(Method::bw1, Method::newton, Method::pd, Method::pd_lbfgs, Method::automatic);
  const TriangleMesh mesh = makeSheet(6, 6, 0.2, 0.2);
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), softCloth());
  TimeStep step = makeStep(cloth, {method, 1e-12, 1e-9, 3000});
  State state = atRest(mesh);
  const Vec3 v0(0.3, 0.5, -0.1);
  state.velocities.rowwise() += v0.transpose();
  const StepOptions options;
  const int n = 40;
  for (int i = 0; i < n; ++i) step.step(state, options, {}, kNoContacts);
  const Vec3 moved = n * options.h * v0 + 0.5 * options.gravity * options.h * options.h * n * (n + 1);
  Positions expected = mesh.positions;
  expected.rowwise() += moved.transpose();
  // bw1 stops after one linear system, solved to a tolerance of 1 %; its correction is h^2 g in this test.
  const double bound = method == Method::bw1 ? 1e-8 : 1e-12;
  CHECK((state.positions - expected).cwiseAbs().maxCoeff() < bound);
}

TEST_CASE("cloth that falls into a narrow groove ends between its sides, not within one of them") {
  const Method method = GENERATE(Method::newton, Method::pd_lbfgs, Method::automatic);
  TriangleMesh mesh = makeSheet(6, 6, 0.06, 0.06);  // upright, its lower edge above the bottom of the groove
  mesh.positions = Positions(mesh.positions.rowwise() - mesh.positions.colwise().mean());
  mesh.positions.col(1).array() += 0.025 - mesh.positions.col(1).minCoeff();
  const Eigen::Vector3d across = Vec3::UnitZ();
  REQUIRE(mesh.positions.col(2).cwiseAbs().maxCoeff() == 0.0);
  const double slope = 10.0 * M_PI / 180.0;
  const std::array<Vec3, 2> sides = {Vec3(0.0, std::sin(slope), 0.0) + std::cos(slope) * across,
                                     Vec3(0.0, std::sin(slope), 0.0) - std::cos(slope) * across};
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), softCloth());
  // As for a body, a sample has the plane of the nearest side alone.
  const FindContacts nearest = [&](const Positions& x, Contacts& contacts) {
    contacts.planes.assign(x.rows() + cloth.topology().edges.size() + cloth.triangleCount(), {});
    for (int i = 0; i < x.rows(); ++i) {
      const Vec3 at = x.row(i);
      contacts.planes[i] = {sides[0].dot(at) < sides[1].dot(at) ? sides[0] : sides[1], 0.005, 0.01};
    }
  };
  TimeStep step = makeStep(cloth, {method, 1e-3, 1e-3, 3000});
  State state = atRest(mesh);
  state.velocities.col(1).setConstant(-2.0);
  StepOptions options;
  options.h = 1.0 / 80.0;  // s: it falls to the bottom in one step
  CHECK(step.step(state, options, {}, nearest).kept_planes > 0);
  for (const Vec3& side : sides) CHECK((state.positions * side).minCoeff() > 0.0);
}

TEST_CASE("cloth goes on falling faster, at the tolerance of every day too") {
  const double h = GENERATE(0.0025, 1.0 / 60.0);
  const Method method = GENERATE(Method::bw1, Method::newton, Method::pd, Method::pd_lbfgs, Method::automatic);
  const TriangleMesh mesh = makeSheet(6, 6, 0.2, 0.2);
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), softCloth());
  TimeStep step = makeStep(cloth, MethodOptions{method});
  State state = atRest(mesh);
  StepOptions options;
  options.h = h;
  const int n = static_cast<int>(std::lround(1.0 / h));
  for (int i = 0; i < n; ++i) step.step(state, options, {}, kNoContacts);
  CHECK(state.velocities.col(1).mean() == Approx(options.gravity.y() * n * h).epsilon(1e-2));
}

TEST_CASE("pinned vertices are where they were told to be, exactly, and may be changed") {
  const Method method = GENERATE(Method::bw1, Method::newton, Method::pd, Method::pd_lbfgs, Method::automatic);
  const TriangleMesh mesh = makeSheet(8, 8, 0.3, 0.3);
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), softCloth());
  TimeStep step = makeStep(cloth, {method});
  State state = atRest(mesh);
  Pins pins{{0, 8}, {mesh.positions.row(0), mesh.positions.row(8)}};
  for (int i = 0; i < 20; ++i) {
    if (i == 10) pins = {{0, 8, 40}, {Vec3(0.0, 0.01, 0.0), Vec3(0.3, 0.01, 0.0), Vec3(0.15, 0.1, 0.02)}};
    step.step(state, {}, pins, kNoContacts);
    for (size_t k = 0; k < pins.vertices.size(); ++k)
      CHECK((state.positions.row(pins.vertices[k]).transpose() - pins.positions[k]).norm() == 0.0);
  }
  CHECK(state.positions.col(1).minCoeff() < mesh.positions.col(1).minCoeff() - 1e-3);
}

TEST_CASE("a hanging strip stretches by its own weight as it should") {
  const Method method = GENERATE(Method::bw1, Method::newton, Method::pd_lbfgs, Method::automatic);
  // A strip of Poisson's ratio zero that hangs from its top edge is displaced by u(X) = rho g / k (L X - X^2/2). The
  // weft is free and shear does not act.
  const double length = 0.5, width = 0.1;
  TriangleMesh mesh = makeSheet(4, 20, width, length);
  mesh.positions.col(1) = mesh.positions.col(1).array() - length;  // top edge at y = 0, hanging down
  Material material = softCloth();
  material.bending = 0.0;
  material.damping_stretch = 5.0;
  material.damping_shear = 5.0;
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), material);
  TimeStep step = makeStep(cloth, {method, 1e-4, 1e-6});
  State state = atRest(mesh);
  Pins pins;
  for (int i = 0; i < mesh.positions.rows(); ++i)
    if (mesh.positions(i, 1) > -1e-9) {
      pins.vertices.push_back(i);
      pins.positions.push_back(mesh.positions.row(i));
    }
  StepOptions options;
  options.h = 0.05;
  for (int i = 0; i < 200; ++i) step.step(state, options, pins, kNoContacts);
  REQUIRE(state.velocities.cwiseAbs().maxCoeff() < 1e-5);
  const double load = material.density * 9.81 / material.stretch_warp;
  for (int i = 0; i < mesh.positions.rows(); ++i) {
    const double X = -mesh.positions(i, 1);
    const double expected = load * (length * X - 0.5 * X * X);
    CHECK(-state.positions(i, 1) - X == Approx(expected).margin(0.01 * load * length * length));
  }
}

TEST_CASE("cloth dropped on a floor stays on it") {
  const Method method = GENERATE(Method::bw1, Method::newton, Method::pd, Method::pd_lbfgs, Method::automatic);
  TriangleMesh mesh = makeSheet(6, 6, 0.2, 0.2);
  mesh.positions.col(2).swap(mesh.positions.col(1));
  mesh.positions.col(1).array() += 0.02;
  const Cloth cloth(mesh, Vec3(0.0, 0.0, -1.0), softCloth());
  TimeStep step = makeStep(cloth, {method});
  State state = atRest(mesh);
  for (int i = 0; i < 200; ++i) step.step(state, {}, {}, floorFor(cloth));
  CHECK(state.positions.col(1).maxCoeff() < 1e-4);
  CHECK(state.positions.col(1).minCoeff() > -1e-4);
  CHECK(state.velocities.cwiseAbs().maxCoeff() < 0.02);
}

TEST_CASE("the same steps with one thread and with two, to the last bit") {
  const Method method = GENERATE(Method::bw1, Method::newton, Method::pd, Method::pd_lbfgs, Method::automatic);
  const TriangleMesh mesh = makeSheet(40, 40, 0.5, 0.5);
  State states[2];
  for (int threads = 1; threads <= 2; ++threads) {
    tbb::task_arena arena(threads);
    arena.execute([&] {
      const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), softCloth());
      TimeStep step = makeStep(cloth, {method});
      State& state = states[threads - 1] = atRest(mesh);
      const Pins pins{{0, 40}, {mesh.positions.row(0), mesh.positions.row(40)}};
      for (int i = 0; i < 10; ++i) step.step(state, {}, pins, kNoContacts);
    });
  }
  CHECK(states[0].positions == states[1].positions);
  CHECK(states[0].velocities == states[1].velocities);
  CHECK((states[0].positions - mesh.positions).norm() > 1e-3);
}

TEST_CASE("a state that is not finite is an error, and stays as it was") {
  const Method method = GENERATE(Method::bw1, Method::newton, Method::pd, Method::pd_lbfgs, Method::automatic);
  const TriangleMesh mesh = makeSheet(4, 4, 0.2, 0.2);
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), softCloth());
  TimeStep step = makeStep(cloth, {method});
  State state = atRest(mesh);
  state.velocities(3, 1) = std::nan("");
  CHECK_THROWS_AS(step.step(state, {}, {}, kNoContacts), ComputationError);
  CHECK(state.positions == mesh.positions);
}

TEST_CASE("all methods run to tolerance find the same minimum, after one step and after a hundred") {
  // The cloth is taut and has only energies that projective dynamics reproduces exactly.
  const TriangleMesh mesh = makeSheet(8, 8, 0.3, 0.3);
  Material material = softCloth();
  material.membrane = GENERATE(Membrane::woven, Membrane::isotropic);
  material.mu = 100.0;
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), material);
  const Pins pins = tautPins(cloth);
  State reference;
  for (const Method method : {Method::newton, Method::pd, Method::pd_lbfgs, Method::automatic}) {
    TimeStep step = makeStep(cloth, tight(method));
    State state = atRest(mesh);
    state.positions *= 1.05;
    state.velocities = 0.2 * randomPositions(cloth.vertexCount(), 3);
    for (int i = 0; i < 100; ++i) step.step(state, {}, pins, kNoContacts);
    if (method == Method::newton) {
      reference = state;
      REQUIRE((state.positions - 1.05 * mesh.positions).rowwise().norm().maxCoeff() > 1e-5);
    }
    CHECK((state.positions - reference.positions).rowwise().norm().maxCoeff() < 1e-6);
  }
}

TEST_CASE("auto finishes a trial of Newton that costs too much with pd-lbfgs") {
  const TriangleMesh mesh = makeSheet(16, 16, 0.3, 0.3);
  Material material = softCloth();
  material.bending = 1e-2;  // the factor of Newton's matrix leaves bending out
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), material);
  TimeStep step = makeStep(cloth, {Method::automatic, 1e-3});
  State state = atRest(mesh);
  state.positions += 1e-3 * randomPositions(cloth.vertexCount(), 4);
  const Pins pins{{0, 16}, {state.positions.row(0), state.positions.row(16)}};
  int finished = 0;
  for (int i = 0; i < 10; ++i) {
    const StepSummary summary = step.step(state, {}, pins, kNoContacts);
    CHECK(summary.converged());
    if (summary.newton_iterations > 0 && summary.projective_iterations > 0 && summary.handed_over == 0) ++finished;
  }
  CHECK(finished == 1);
}

TEST_CASE("auto hands over to Newton where the projective method is slow, and not where it is fast") {
  const TriangleMesh mesh = makeSheet(16, 16, 0.3, 0.3);
  for (const bool hard : {false, true}) {
    Material material = softCloth();
    material.stretch_warp = material.stretch_weft = hard ? 1e5 : 10.0;
    const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), material);
    TimeStep step = makeStep(cloth, {Method::automatic, hard ? 1e-5 : 0.05});
    State state = atRest(mesh);
    if (hard) state.positions.col(0) *= 1.02;
    const Pins pins{{0, 16}, {state.positions.row(0), state.positions.row(16)}};
    StepOptions options;
    options.h = hard ? 1.0 / 60.0 : 0.0025;
    int handed_over = 0;
    for (int i = 0; i < 10; ++i) {
      const StepSummary summary = step.step(state, options, pins, kNoContacts);
      handed_over += static_cast<int>(summary.handed_over);
      CHECK(summary.converged());
    }
    CHECK((handed_over > 0) == hard);
  }
}
