#include "garment/pattern/normal_clusters.h"

#include <catch2/catch.hpp>

#include <set>

#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

TEST_CASE("what faces alike is one region, what faces elsewhere another") {
  CHECK(normalClusters(flatSheet(6, 1.0)).labels == 1);
  const Clusters around = normalClusters(surfaceOf(cone(48, 6, 0.1, 3.0, false)));
  CHECK(around.labels >= 3);
  CHECK(std::set<int>(around.label.begin(), around.label.end()).size() == static_cast<size_t>(around.labels));
}

TEST_CASE("labels are no more than asked for") {
  const Clusters few = normalClusters(surfaceOf(cone(96, 6, 0.1, 3.0, false)), 0.1, 3);
  CHECK(few.labels == 3);
}
