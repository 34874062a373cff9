#include "bench/machine_bounds.h"

#include <catch2/catch.hpp>
#include <numeric>

using namespace ease;

TEST_CASE("a dense factor takes the sum of squares, and one of blocks as much as its scalar one") {
  constexpr int kRows = 12;
  SparseMatrix dense(kRows, kRows), quarter(kRows / 3, kRows / 3);
  for (SparseMatrix* matrix : {&dense, &quarter})
    for (int j = 0; j < matrix->cols(); ++j)
      for (int i = j; i < matrix->rows(); ++i) matrix->insert(i, j) = 1.0;
  std::vector<int> ordering(kRows);
  std::iota(ordering.rbegin(), ordering.rend(), 0);
  CHECK(factorFlops(dense, ordering, 1) == kRows * (kRows + 1) * (2 * kRows + 1) / 6);
  ordering = {2, 0, 3, 1};
  CHECK(factorFlops(quarter, ordering, 3) ==
        factorFlops(dense, std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, 1));
}

TEST_CASE("a chain fills in where its middle goes first, and nowhere from its ends") {
  SparseMatrix chain(3, 3);
  for (int j = 0; j < 3; ++j)
    for (int i = j; i < std::min(j + 2, 3); ++i) chain.insert(i, j) = 1.0;
  CHECK(factorFlops(chain, std::vector<int>{0, 1, 2}, 1) == 4 + 4 + 1);
  CHECK(factorFlops(chain, std::vector<int>{1, 0, 2}, 1) == 9 + 4 + 1);
}
