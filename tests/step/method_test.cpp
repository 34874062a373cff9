#include "solver/step/method.h"

#include <catch2/catch.hpp>
#include <stdexcept>

using namespace ease;

TEST_CASE("an unknown method has no name") {
  CHECK(methodNamed("pd-lbfgs") == Method::pd_lbfgs);
  CHECK_THROWS_AS(methodNamed("euler"), std::out_of_range);
}

TEST_CASE("counts of steps add up") {
  StepSummary all, step;
  step.newton_iterations = 2;
  step.short_of_tolerance = 1;
  all += step;
  all += step;
  CHECK(all.newton_iterations == 4);
  CHECK(all.projective_iterations == 0);
  CHECK_FALSE(all.converged());
}
