#include "solver/mesh/disjoint_sets.h"

#include <catch2/catch.hpp>

using namespace ease;

TEST_CASE("joined items share the smallest item of their set, in whatever order they were joined") {
  const std::vector<std::pair<int, int>> pairs = {{4, 2}, {5, 4}, {1, 3}, {6, 5}};
  for (const bool is_reversed : {false, true}) {
    DisjointSets sets(7);
    for (size_t k = 0; k < pairs.size(); ++k) {
      const auto [a, b] = pairs[is_reversed ? pairs.size() - 1 - k : k];
      sets.join(a, b);
    }
    const int smallest[] = {0, 1, 2, 1, 2, 2, 2};
    for (int i = 0; i < 7; ++i) CHECK(sets.find(i) == smallest[i]);
  }
}
