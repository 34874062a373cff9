// The elements around each vertex. With it a loop over vertices adds up results of elements in a fixed order and
// without write conflicts between threads.
#pragma once

#include <span>
#include <vector>

namespace ease {

/// Lists for each vertex the element corners at it, as element * (corners per element) + corner, in ascending order.
class Incidence {
 public:
  /// `element_vertices`: vertex indices, the same number for each element; negative ones are skipped.
  Incidence(int vertices, std::span<const int> element_vertices) : start_(vertices + 1, 0) {
    for (int v : element_vertices)
      if (v >= 0) ++start_[v + 1];
    for (int v = 0; v < vertices; ++v) start_[v + 1] += start_[v];
    entries_.resize(start_[vertices]);
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (int k = 0; k < static_cast<int>(element_vertices.size()); ++k)
      if (element_vertices[k] >= 0) entries_[next[element_vertices[k]]++] = k;
  }

  std::span<const int> of(int vertex) const {
    return {entries_.data() + start_[vertex], entries_.data() + start_[vertex + 1]};
  }
  /// How many entries come before those of the vertex.
  int before(int vertex) const { return start_[vertex]; }

 private:
  std::vector<int> start_;
  std::vector<int> entries_;
};

}  // namespace ease
