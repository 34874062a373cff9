// Compares a method's own statement whether a step converged with the true error of the step.
#include <catch2/catch.hpp>

#include "tests/step/soft_sheet.h"

using namespace ease;

namespace {

struct ToldStep {
  StepSummary summary;
  double error;  // relative error; the reference is Newton's method down to round-off
};

/// Steps of a taut sheet in motion. Each starts from the exact end of the step before.
std::vector<ToldStep> toldSteps(const Material& material, double h, const MethodOptions& options, int steps) {
  const TriangleMesh mesh = makeSheet(12, 12, 0.3, 0.3);
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), material);
  TimeStep step = makeStep(cloth, options), newton = makeStep(cloth, {Method::newton, 0.0, 1e-7});
  const Pins pins = tautPins(cloth);
  State state = atRest(mesh);
  state.positions *= 1.05;
  state.velocities = 0.5 * randomPositions(cloth.vertexCount(), 4);
  StepOptions step_options;
  step_options.h = h;
  std::vector<ToldStep> told;
  for (int n = 0; n < steps; ++n) {
    State exact = state;
    newton.step(exact, step_options, pins, kNoContacts);
    const StepSummary summary = step.step(state, step_options, pins, kNoContacts);
    Point minimum;
    minimum.x = exact.positions;
    minimum.evaluate(newton.potential(), std::vector<char>(cloth.vertexCount(), 0));
    told.push_back({summary, relativeLength(newton.potential(), minimum, state.positions - exact.positions)});
    state = exact;
  }
  return told;
}

Material withStretch(double stiffness) {
  Material material = softCloth();
  material.stretch_warp = material.stretch_weft = stiffness;
  return material;
}

}  // namespace

TEST_CASE("auto keeps to the tolerance that is asked of it") {
  const double stiffness = GENERATE(30.0, 1e3, 3e4, 1e6), h = GENERATE(1.0 / 240.0, 1.0 / 30.0, 0.2);
  const double tolerance = GENERATE(0.05, 1e-3);
  double error = 0.0;
  for (const ToldStep& step : toldSteps(withStretch(stiffness), h, {Method::automatic, tolerance}, 12)) {
    CHECK(
        (step.summary.converged() || stiffness > 1e5));  // round-off ends some of the stiffest steps, which is reported
    error += step.error / 12;
  }
  INFO("stiffness " << stiffness << " N/m, h " << h << " s, tolerance " << tolerance);
  CHECK(error < tolerance);
}

TEST_CASE("pd does its iterations, and says whether they were enough") {
  const int iterations = GENERATE(10, 1000);
  const std::vector<ToldStep> steps =
      toldSteps(withStretch(GENERATE(2e3, 1e5)), 1.0 / 60.0, {Method::pd, 0.05, 1e-2, iterations}, 6);
  CHECK(steps.front().summary.converged() == (iterations == 1000));
  for (const ToldStep& step : steps) {
    CHECK(step.summary.projective_iterations <= iterations);  // fewer if round-off ends the step
    INFO("error " << step.error);
    CHECK((!step.summary.converged() || step.error < 0.05));
  }
}

TEST_CASE("bw1 does its iteration, and says whether it was enough") {
  const double h = GENERATE(1e-3, 1.0 / 30.0);
  const std::vector<ToldStep> steps = toldSteps(softCloth(), h, {Method::bw1}, 6);
  CHECK(steps.front().summary.converged() == (h < 0.01));
  for (const ToldStep& step : steps) {
    CHECK(step.summary.newton_iterations == 1);
    INFO("h " << h << " s, error " << step.error);
    CHECK((!step.summary.converged() || step.error < 0.05));
  }
}
