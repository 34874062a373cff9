// Disjoint sets (union-find): which of n items belong together, found by joining pairs.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace ease {

/// Sets of the items 0 to n - 1, each item alone at first.  The smallest item of a set represents it, so that the
/// result does not depend on the order of the joins.
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// Returns the smallest item of the set that holds `item`.
  int find(int item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }

  /// Merges the sets of two items.
  void join(int first, int second) {
    const int p = find(first), q = find(second);
    parent_[std::max(p, q)] = std::min(p, q);
  }

 private:
  std::vector<int> parent_;
};

}  // namespace ease
