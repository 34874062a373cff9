// Inner product of two n x 3 arrays. The result is equal to the last bit for any number of threads.
#pragma once

#include <array>
#include <numeric>

#include "solver/base/parallel.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

inline double dot(const Positions& a, const Positions& b) {
  constexpr int kRows = 1024, kParts = 64, kSerialBelow = 16384;
  const int n = static_cast<int>(a.rows());
  const int blocks = (n + kRows - 1) / kRows, per_part = (blocks + kParts - 1) / kParts;
  std::array<double, kParts> partial{};
  parallelFor(kParts, n < kSerialBelow ? kParts : 4, [&](int part) {
    for (int block = part * per_part; block < std::min(blocks, (part + 1) * per_part); ++block) {
      const int begin = block * kRows, rows = std::min(kRows, n - begin);
      partial[part] += a.middleRows(begin, rows).cwiseProduct(b.middleRows(begin, rows)).sum();
    }
  });
  return std::accumulate(partial.begin(), partial.end(), 0.0);
}

}  // namespace ease
