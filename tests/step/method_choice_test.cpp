#include "solver/step/method_choice.h"

#include <catch2/catch.hpp>

using namespace ease;

namespace {

struct Sum {
  double cost = 0.0;
  int newton_steps = 0;
};

/// Records steps that cost `pd_lbfgs` or `newton`, by the method chosen. Every tenth step also costs Newton `factor`
/// for a factorisation.
Sum walk(MethodChoice& choice, int steps, double pd_lbfgs, double newton, double factor = 0.0) {
  Sum sum;
  for (int n = 0; n < steps; ++n) {
    const bool by_newton = choice.newtonFirst();
    const double cost = by_newton ? newton : pd_lbfgs, once = by_newton && n % 10 == 0 ? factor : 0.0;
    sum.newton_steps += by_newton;
    sum.cost += cost + once;
    by_newton ? choice.recordCost(0.0, newton, once) : choice.recordCost(pd_lbfgs, 0.0, 0.0);
  }
  return sum;
}

}  // namespace

TEST_CASE("steps that cost little are left to pd-lbfgs") {
  MethodChoice choice;
  CHECK(walk(choice, 1000, 8.0, 5.0).newton_steps == 0);
}

TEST_CASE("the cheaper method is found within a few steps, and trials of the other cost a few per cent") {
  MethodChoice choice;
  SECTION("Newton") {
    const Sum sum = walk(choice, 1000, 40.0, 10.0);
    CHECK(sum.newton_steps > 980);
    CHECK(sum.cost < 1.05 * 1000 * 10.0);
  }
  SECTION("pd-lbfgs") {
    const Sum sum = walk(choice, 1000, 40.0, 400.0);
    CHECK(sum.newton_steps <= 4);
    CHECK(sum.cost < 1.05 * 1000 * 40.0);
  }
}

TEST_CASE("a trial of Newton may cost what pd-lbfgs has cost, once Newton is in use, any number") {
  MethodChoice choice;
  CHECK(choice.newtonPatience() == 0);
  for (int n = 0; n < 100 && !choice.newtonFirst(); ++n) choice.recordCost(40.0, 0.0, 0.0);
  REQUIRE(choice.newtonFirst());
  CHECK(choice.newtonPatience() == 40);
  choice.recordCost(0.0, 10.0, 0.0);
  REQUIRE(choice.newtonFirst());
  CHECK(choice.newtonPatience() == 0);
}

TEST_CASE("a method that ceases to be the cheaper one is given up") {
  MethodChoice choice;
  walk(choice, 100, 40.0, 10.0);
  REQUIRE(choice.newtonFirst());
  CHECK(walk(choice, 100, 40.0, 200.0).newton_steps < 10);
  REQUIRE_FALSE(choice.newtonFirst());
  walk(choice, 300, 40.0, 10.0);
  CHECK(walk(choice, 100, 40.0, 10.0).newton_steps > 90);
}

TEST_CASE("factors count for a method in use") {
  MethodChoice choice;
  CHECK(walk(choice, 1000, 20.0, 10.0, 1000.0).newton_steps < 100);
}

TEST_CASE("pd-lbfgs is given as long as Newton has cost lately, its factors included") {
  MethodChoice choice;
  const int first = choice.patience();
  choice.recordCost(30.0, 0.0, 0.0);
  CHECK(choice.patience() == first);
  for (int n = 0; n < 40; ++n) choice.recordCost(100.0, 300.0, 60.0);  // pd-lbfgs handed over in these steps
  CHECK(choice.patience() == Approx(360).margin(1));
}
