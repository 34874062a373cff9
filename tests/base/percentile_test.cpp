#include "solver/base/percentile.h"

#include <catch2/catch.hpp>

using namespace ease;

TEST_CASE("a percentile is the value of its rank, rounded down") {
  std::vector<double> values = {5.0, 1.0, 4.0, 2.0, 3.0};
  CHECK(percentile(values, 0.0) == 1.0);
  CHECK(percentile(values, 0.5) == 3.0);
  CHECK(percentile(values, 0.74) == 3.0);
  CHECK(percentile(values, 0.75) == 4.0);
  CHECK(percentile(values, 1.0) == 5.0);
  std::vector<double> one = {7.0};
  CHECK(percentile(one, 0.99) == 7.0);
}
