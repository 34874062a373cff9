#include "garment/pattern/equal_sides.h"

#include <algorithm>
#include <cmath>

namespace ease {
namespace {

constexpr int kRounds = 50;
constexpr double kTolerance = 1e-3;  // mm

/// Stretches the edges of a piece by their factors and closes its outline.
void stretch(const std::vector<double>& factors, SewLine& line) {
  PaperPoint open = PaperPoint::Zero();
  double length = 0.0;
  for (size_t i = 0; i < line.edges.size(); ++i) {
    const std::vector<PaperPoint>& points = line.edges[i].points;
    open += factors[line.numbers[i]] * (points.back() - points.front());
    for (size_t k = 0; k + 1 < points.size(); ++k) length += (points[k + 1] - points[k]).norm();
  }
  const PaperPoint closing = -open / length;
  PaperPoint at = line.edges.front().points.front(), shift = PaperPoint::Zero();
  for (size_t i = 0; i < line.edges.size(); ++i) {
    std::vector<PaperPoint>& points = line.edges[i].points;
    PaperPoint before = points.front();
    points.front() = at;
    for (size_t k = 1; k < points.size(); ++k) {
      const PaperPoint way = points[k] - before;
      before = points[k];
      at += factors[line.numbers[i]] * way + way.norm() * closing;
      shift += way.norm() / length * (before - at);
      points[k] = at;
    }
  }
  for (SewnEdge& edge : line.edges)
    for (PaperPoint& point : edge.points) point += shift;
}

}  // namespace

double makeSidesEqual(const CutGarment& cut, std::vector<SewLine>& lines) {
  const std::vector<SewLine> drawn = lines;
  std::vector<double> factors(cut.edges.size(), 1.0), wanted = drawnLengths(cut, lines);
  for (size_t e = 0; e < wanted.size(); ++e)
    if (const int partner = cut.edges[e].partner; partner > static_cast<int>(e))
      wanted[e] = wanted[partner] = 0.5 * (wanted[e] + wanted[partner]);
  double worst = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    lines = drawn;
    for (SewLine& line : lines) stretch(factors, line);
    const std::vector<double> lengths = drawnLengths(cut, lines);
    worst = 0.0;
    for (size_t e = 0; e < wanted.size(); ++e) {
      if (cut.edges[e].partner < 0) continue;
      worst = std::max(worst, std::abs(lengths[e] - lengths[cut.edges[e].partner]));
      factors[e] *= wanted[e] / lengths[e];
    }
    if (worst < kTolerance) break;
  }
  return worst;
}

}  // namespace ease
