#include "bench/accelerated_pd.h"

#include <catch2/catch.hpp>

#include "bench/step_error.h"
#include "solver/base/error.h"

using namespace ease;

namespace {

constexpr double kStep = 1.0 / 60.0;  // s

/// Two steps of a taut sheet, so that the second finds everything prepared.
struct Scene {
  std::unique_ptr<Sheet> sheet = makeTautSheet(16, 500.0);
  std::vector<ReferenceStep> steps = referenceSteps(*sheet, kStep, 0.1, 2);
  StepJudge judge{*sheet};

  template <class Method>
  double errorOf(Method& method) {
    double error = 0.0;
    for (const ReferenceStep& from : steps) {
      State state = from.start;
      advance(*sheet, method, from.time, kStep, state);
      error = judge.judge(from, kStep, state.positions).error;
    }
    return error;
  }
  double pdError(int iterations) {
    TimeStep pd(sheet->cloth, {Method::pd, 0.0, 0.0, iterations}, sheet->ordering);
    return errorOf(pd);
  }
  double acceleratedError(Acceleration acceleration, int iterations) {
    AcceleratedPd pd(sheet->cloth, acceleration, iterations, sheet->ordering);
    return errorOf(pd);
  }
};

}  // namespace

TEST_CASE("one accelerated iteration is one of pd, and many come to Newton's minimum, in a third of pd's") {
  Scene scene;
  for (Acceleration acceleration : {Acceleration::anderson, Acceleration::chebyshev}) {
    CAPTURE(static_cast<int>(acceleration));
    CHECK(scene.acceleratedError(acceleration, 1) == Approx(scene.pdError(1)).epsilon(1e-6));
    CHECK(scene.acceleratedError(acceleration, 30) < scene.pdError(90));
    CHECK(scene.acceleratedError(acceleration, 200) < 1e-7);
  }
}

TEST_CASE("accelerated pd refuses contact, which its matrix does not bound") {
  const auto sheet = makeTautSheet(4, 500.0);
  AcceleratedPd pd(sheet->cloth, Acceleration::anderson, 3, sheet->ordering);
  State state = sheet->start;
  const auto find = [&](const Positions& x, Contacts& contacts) { contacts.planes.resize(x.rows()); };
  CHECK_THROWS_AS(pd.step(state, {}, {}, find), ComputationError);
  CHECK(state.positions == sheet->start.positions);
}
