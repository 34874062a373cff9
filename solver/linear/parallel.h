// Data-parallel loops whose results do not depend on the number of threads.
//
// Elements are independent in parallelFor; parallelSum adds partial sums of 64 fixed blocks in a fixed order.
#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace ease {

/// Calls body(i) for i in [0, count), in parallel over blocks of `grain`; serial below one block.
template <class Body>
void parallelFor(int count, int grain, const Body& body) {
  if (count <= grain) {
    for (int i = 0; i < count; ++i) body(i);
    return;
  }
  tbb::parallel_for(tbb::blocked_range<int>(0, count, grain), [&](const tbb::blocked_range<int>& range) {
    for (int i = range.begin(); i < range.end(); ++i) body(i);
  });
}

/// Sum of term(i) over [0, count), the same to the last bit for any number of threads.
template <class Term>
double parallelSum(int count, const Term& term) {
  constexpr int kBlocks = 64;
  const int block = (count + kBlocks - 1) / kBlocks;
  std::array<double, kBlocks> partial;
  const auto sumBlock = [&](int b) {
    double sum = 0.0;
    for (int i = b * block; i < std::min(count, (b + 1) * block); ++i) sum += term(i);
    partial[b] = sum;
  };
  parallelFor(kBlocks, count < 4096 ? kBlocks : 4, sumBlock);
  double sum = 0.0;
  for (double p : partial) sum += p;
  return sum;
}

}  // namespace ease
