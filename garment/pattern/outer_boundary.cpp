#include "garment/pattern/outer_boundary.h"

#include <algorithm>
#include <cmath>

#include "garment/pattern/outline_crossing.h"

namespace ease {
namespace {

/// A crossing on a segment: how far along it, and where on which other segment.
struct Crossing {
  double along;
  size_t other;
  double along_other;
  PaperPoint at;
};

std::vector<std::vector<Crossing>> crossingsOf(const std::vector<PaperPoint>& line) {
  const size_t n = line.size();
  std::vector<std::vector<Crossing>> crossings(n);
  double s = 0.0, t = 0.0;
  for (size_t i = 0; i < n; ++i)
    for (size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const PaperPoint &a = line[i], &b = line[(i + 1) % n], &c = line[j], &d = line[(j + 1) % n];
      if (std::max(a.x(), b.x()) < std::min(c.x(), d.x()) || std::max(c.x(), d.x()) < std::min(a.x(), b.x())) continue;
      if (!crossing(a, b, c, d, s, t)) continue;
      const PaperPoint at = a + s * (b - a);
      crossings[i].push_back({s, j, t, at});
      crossings[j].push_back({t, i, s, at});
    }
  for (auto& on : crossings)
    std::sort(on.begin(), on.end(), [](const Crossing& p, const Crossing& q) { return p.along < q.along; });
  return crossings;
}

}  // namespace

std::vector<PaperPoint> outerBoundary(const std::vector<PaperPoint>& given) {
  constexpr double kSame = 1e-6;  // mm
  std::vector<PaperPoint> line;
  for (const PaperPoint& p : given)
    if (line.empty() || (p - line.back()).norm() > kSame) line.push_back(p);
  while (line.size() > 1 && (line.front() - line.back()).norm() <= kSame) line.pop_back();
  const size_t n = line.size();
  if (n < 3) return {};
  const std::vector<std::vector<Crossing>> crossings = crossingsOf(line);
  const auto lowest = std::min_element(line.begin(), line.end(), [](const PaperPoint& p, const PaperPoint& q) {
    return p.y() != q.y() ? p.y() < q.y() : p.x() < q.x();
  });
  const size_t start = static_cast<size_t>(lowest - line.begin());
  std::vector<PaperPoint> boundary = {line[start]};
  size_t segment = start;  // the way runs along it, forwards or backwards
  bool forwards = true;
  double along = 0.0;
  for (size_t steps = 0; steps < 8 * n; ++steps) {
    // The next crossing on this segment, or its end.
    const Crossing* next = nullptr;
    for (const Crossing& c : crossings[segment])
      if (forwards ? c.along > along && (!next || c.along < next->along)
                   : c.along < along && (!next || c.along > next->along))
        next = &c;
    if (!next) {
      const size_t end = forwards ? (segment + 1) % n : segment;
      if (end == start) return boundary;
      boundary.push_back(line[end]);
      segment = forwards ? end : (segment + n - 1) % n;
      along = forwards ? 0.0 : 1.0;
      continue;
    }
    boundary.push_back(next->at);
    const PaperPoint d = (forwards ? 1.0 : -1.0) * (line[(segment + 1) % n] - line[segment]);
    const PaperPoint e = line[(next->other + 1) % n] - line[next->other];
    forwards = d.x() * e.y() - d.y() * e.x() < 0.0;  // one of both directions of the other segment leads to the right
    segment = next->other;
    along = next->along_other;
  }
  return {};
}

}  // namespace ease
