// Inner product of two n x 3 arrays. The result is equal to the last bit for any number of threads.
#pragma once

#include "solver/base/parallel.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

inline double dot(const Positions& a, const Positions& b) {
  constexpr int kRows = 1024;
  const int n = static_cast<int>(a.rows());
  return parallelSum((n + kRows - 1) / kRows, [&](int block) {
    const int begin = block * kRows, rows = std::min(kRows, n - begin);
    return a.middleRows(begin, rows).cwiseProduct(b.middleRows(begin, rows)).sum();
  });
}

}  // namespace ease
