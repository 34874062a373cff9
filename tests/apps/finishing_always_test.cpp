#include "apps/finishing_always.h"

#include <catch2/catch.hpp>
#include <stdexcept>

using namespace ease;

TEST_CASE("work is finished once, also where its computation fails, but not where it may not go on") {
  int finished = 0;
  const auto finish = [&] { ++finished; };
  finishingAlways([] {}, finish);
  CHECK(finished == 1);
  CHECK_THROWS_AS(finishingAlways([] { throw ComputationError("no"); }, finish), ComputationError);
  CHECK(finished == 2);
  CHECK_THROWS_AS(finishingAlways([] { throw std::logic_error("no"); }, finish), std::logic_error);
  CHECK(finished == 2);
}
