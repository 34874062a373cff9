#include "garment/pattern/outline_crossing.h"

#include <algorithm>
#include <numeric>

namespace ease {

bool crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d,
              double& along_ab, double& along_cd) {
  const Eigen::Vector2d p = b - a, q = d - c, r = c - a;
  const double det = p.x() * q.y() - p.y() * q.x();
  if (det == 0.0) return false;
  along_ab = (r.x() * q.y() - r.y() * q.x()) / det;
  along_cd = (r.x() * p.y() - r.y() * p.x()) / det;
  return along_ab >= 0.0 && along_ab <= 1.0 && along_cd >= 0.0 && along_cd <= 1.0;
}

bool crossesItself(const std::vector<int>& outline, const Positions& x) {
  return !crossings(outline, x).empty();
}

std::vector<std::pair<size_t, size_t>> crossings(const std::vector<int>& outline, const Positions& x) {
  std::vector<std::pair<size_t, size_t>> found;
  const size_t n = outline.size();
  const auto at = [&](size_t i) -> Eigen::Vector2d { return x.row(outline[i % n]).head<2>(); };
  std::vector<size_t> order(n);  // edges by their left end: only those that overlap along x can cross
  std::iota(order.begin(), order.end(), 0);
  const auto left = [&](size_t i) { return std::min(at(i).x(), at(i + 1).x()); };
  const auto right = [&](size_t i) { return std::max(at(i).x(), at(i + 1).x()); };
  std::sort(order.begin(), order.end(), [&](size_t i, size_t j) { return left(i) < left(j); });
  double s = 0.0, t = 0.0;
  for (size_t k = 0; k < n; ++k)
    for (size_t l = k + 1; l < n && left(order[l]) <= right(order[k]); ++l) {
      const size_t i = order[k], j = order[l];
      if ((i + 1) % n == j || (j + 1) % n == i) continue;
      if (crossing(at(i), at(i + 1), at(j), at(j + 1), s, t)) found.push_back(std::minmax(i, j));
    }
  return found;
}

}  // namespace ease
