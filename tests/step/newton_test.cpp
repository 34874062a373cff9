#include "solver/step/newton.h"

#include <catch2/catch.hpp>

#include "solver/linear/gradient_system.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

Material woven() {
  Material material;
  material.bending = 1e-5;
  return material;
}

/// A time step of a sheet that is stretched and disturbed; two of its vertices are pinned.
struct Step {
  TriangleMesh mesh = makeSheet(7, 6, 0.2, 0.2, 0.2);
  Cloth cloth{mesh, Vec3(0.2, -1.0, 0.0), woven()};
  std::vector<int> ordering = systemOrdering(cloth.vertexCount(), cloth.triangles());
  std::vector<char> fixed;
  IncrementalPotential potential{cloth};
  State state{1.05 * mesh.positions + 2e-3 * randomPositions(cloth.vertexCount(), 4),
              0.3 * randomPositions(cloth.vertexCount(), 5)};
  Point point;

  Step() : fixed(cloth.vertexCount(), 0) {
    fixed[0] = fixed[7] = 1;
    restart();
  }
  void restart() {
    potential.begin(state, {});
    point.x = state.positions;
    point.evaluate(potential, fixed);
  }
};

}  // namespace

TEST_CASE("by the exact Hessian every Newton iteration leaves a tenth of the residual or less, down to rounding") {
  Step s;
  std::vector<double> left;
  for (int iterations = 3; iterations <= 7; ++iterations) {  // the first two use the projected Hessian
    s.restart();
    Newton(s.cloth, s.ordering).minimise(s.potential, s.fixed, {iterations}, s.point);
    left.push_back(residualAcceleration(s.potential, s.point));
  }
  REQUIRE(left[0] > 1.0);
  for (size_t k = 0; k + 1 < left.size(); ++k) CHECK(left[k + 1] < std::max(0.1 * left[k], 1e-5));
  CHECK(left.back() < 1e-5);
}

TEST_CASE("Newton ends after the iterations of conjugate gradients that it may take, below where it began") {
  Step s;
  const double before = s.point.energy;
  const StopRule stop{.max_iterations = 100, .error = 1e-9, .max_cg_iterations = 2};
  const MinimiserSummary summary = Newton(s.cloth, s.ordering).minimise(s.potential, s.fixed, stop, s.point);
  CHECK(summary.cg_iterations == 2);
  CHECK_FALSE(summary.converged);
  CHECK(s.point.energy < before);
}

TEST_CASE("one Newton iteration is one linear system and lowers the potential") {
  Step s;
  Newton newton(s.cloth, s.ordering);
  const double before = s.point.energy;
  const MinimiserSummary summary = newton.minimise(s.potential, s.fixed, {1}, s.point);
  CHECK(summary.iterations == 1);
  CHECK(summary.factorisations == 1);
  CHECK(summary.cg_iterations >= 1);
  CHECK_FALSE(summary.converged);
  CHECK(s.point.energy < before);
  Point again;
  again.x = s.point.x;
  again.evaluate(s.potential, s.fixed);
  CHECK(again.energy == s.point.energy);
  CHECK(again.gradient == s.point.gradient);
}

TEST_CASE("Newton's method leaves pinned vertices where they are") {
  Step s;
  Newton newton(s.cloth, s.ordering);
  CHECK(newton.minimise(s.potential, s.fixed, {30, 1e-3}, s.point).converged);
  for (int i = 0; i < s.cloth.vertexCount(); ++i)
    CHECK((s.point.x.row(i) == s.state.positions.row(i)) == static_cast<bool>(s.fixed[i]));
}

TEST_CASE("Newton's method stops at the error or at the residual acceleration asked for, and not before") {
  Step s;
  Newton newton(s.cloth, s.ordering);
  REQUIRE(newton.minimise(s.potential, s.fixed, {60, 0.0, 1e-6}, s.point).converged);
  CHECK(residualAcceleration(s.potential, s.point) <= 1e-6);
  const Positions reference = s.point.x;
  const double way = std::sqrt(s.potential.kinetic(reference - s.state.positions));
  int before = 0;
  for (const double error : {0.1, 1e-2, 1e-3}) {
    s.restart();
    const MinimiserSummary summary = newton.minimise(s.potential, s.fixed, {60, error}, s.point);
    CHECK(summary.converged);
    CHECK(std::sqrt(s.potential.kinetic(s.point.x - reference)) < error * way);
    CHECK(summary.iterations >= before);
    before = summary.iterations;
  }
  CHECK(newton.minimise(s.potential, s.fixed, {60, 0.0, 1e9}, s.point).iterations ==
        0);  // the start meets this tolerance
}

TEST_CASE("after forgetting, Newton's method is to the last bit what it is when new") {
  Step s;
  Newton fresh(s.cloth, s.ordering), used(s.cloth, s.ordering);
  fresh.minimise(s.potential, s.fixed, {2}, s.point);
  const Positions expected = s.point.x;
  s.restart();
  used.minimise(s.potential, s.fixed, {20, 1e-6}, s.point);
  used.forget();
  s.restart();
  CHECK(used.minimise(s.potential, s.fixed, {2}, s.point).factorisations == 1);
  CHECK(s.point.x == expected);
}
