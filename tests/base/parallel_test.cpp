#include "solver/base/parallel.h"

#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "solver/linear/incidence.h"

using namespace ease;

TEST_CASE("a parallel sum is the same to the last bit with any number of threads") {
  const auto term = [](int i) { return std::sin(0.1 * i) / (1.0 + i); };
  double sums[3];
  for (int threads = 1; threads <= 3; ++threads) {
    tbb::task_arena arena(threads);
    arena.execute([&] { sums[threads - 1] = parallelSum(100000, term); });
  }
  CHECK(sums[0] == sums[1]);
  CHECK(sums[0] == sums[2]);
  double plain = 0.0;
  for (int i = 0; i < 100000; ++i) plain += term(i);
  CHECK(sums[0] == Approx(plain).epsilon(1e-12));
  CHECK(parallelSum(0, term) == 0.0);
}

TEST_CASE("loops within loops do all their work, and what one throws reaches the caller") {
  std::vector<int> done(4000, 0);
  parallelFor(40, 1, [&](int i) { parallelFor(100, 8, [&](int j) { ++done[100 * i + j]; }); });
  CHECK(std::count(done.begin(), done.end(), 1) == 4000);
  for (int failing : {0, 1, 39})
    CHECK_THROWS_AS(parallelFor(40, 1,
                                [&](int i) {
                                  if (i == failing) throw std::runtime_error("no");
                                }),
                    std::runtime_error);
}

TEST_CASE("incidence lists every corner of every vertex once, in ascending order") {
  const std::vector<int> corners{0, 1, 2, 2, 1, 3, -1, 3, 0};
  const Incidence incidence(4, corners);
  const auto listed = [&](int v) { return std::vector<int>(incidence.of(v).begin(), incidence.of(v).end()); };
  CHECK(listed(0) == std::vector<int>{0, 8});
  CHECK(listed(1) == std::vector<int>{1, 4});
  CHECK(listed(2) == std::vector<int>{2, 3});
  CHECK(listed(3) == std::vector<int>{5, 7});
}
