// Shortest ways along a part's edges from its outline to the tips of possible darts.
#pragma once

#include "garment/pattern/dart_trial.h"

namespace ease {

constexpr double kMinDartLength = 0.03;  // m

/// Shortest ways to all vertices; an unreachable vertex has the length infinity.
struct Ways {
  std::vector<double> length;  // by vertex, m
  std::vector<int> before;     // by vertex; -1 where a way begins

  /// The vertices of the way that ends at `tip`.
  std::vector<int> to(int tip) const;
};

/// The edges of a part, with their lengths at rest.
class PartEdges {
 public:
  explicit PartEdges(const PieceMesh& part);

  /// From all vertices with `starts`, over vertices without `blocked`.
  Ways waysFrom(const std::vector<char>& starts, const std::vector<char>& blocked) const;

  /// The way between two vertices, over vertices without `blocked`, that stays nearest to the straight line between
  /// them in the plane; empty where there is none.  `x`: positions in the plane, m.
  std::vector<int> straightWay(int from, int to, const Positions& x, const std::vector<char>& blocked) const;

  /// By vertex, whether it lies on the outline.
  const std::vector<char>& isOutline() const { return is_outline_; }

 private:
  Ways cheapest(const std::vector<char>& starts, const std::vector<char>& blocked,
                const std::vector<double>& price) const;

  std::vector<std::vector<std::pair<int, double>>> neighbours_;  // by vertex: vertex and length, m
  std::vector<char> is_outline_;
};

/// At most `count` vertices at the ends of ways that are long enough for a dart: each as far as possible in the plane
/// from those before it, the first at the end of the longest way.  `x`: positions in the plane, m.
std::vector<int> spreadTips(const Ways& ways, const Positions& x, int count);

}  // namespace ease
