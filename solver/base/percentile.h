// The value at or below which a given share of the values lies.
#pragma once

#include <algorithm>
#include <vector>

namespace ease {

/// Returns the value of rank floor(share (n - 1)) of n > 0 values, the smallest having rank 0; 0 <= share <= 1.
/// Reorders the values.
inline double percentile(std::vector<double>& values, double share) {
  const auto rank = values.begin() + static_cast<long>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), rank, values.end());
  return *rank;
}

}  // namespace ease
