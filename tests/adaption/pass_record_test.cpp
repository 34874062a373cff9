#include "adaption/pass_record.h"

#include <catch2/catch.hpp>

using namespace ease;

TEST_CASE("a stretch record keeps the largest of each statistic, and every pose by itself") {
  StretchRecord record;
  record.add({1.2, 1.1, 0.3}, 0);
  record.add({1.1, 1.15, 0.1}, -1);
  record.add({1.3, 1.05, 0.2}, 2);
  CHECK(record.moments == 3);
  CHECK(record.overall.max == 1.3);
  CHECK(record.overall.p99 == 1.15);
  CHECK(record.overall.share_over_limit == 0.3);
  REQUIRE(record.poses.size() == 3);
  CHECK(record.poses[0]->max == 1.2);
  CHECK_FALSE(record.poses[1].has_value());
  CHECK(record.poses[2]->p99 == 1.05);
}
