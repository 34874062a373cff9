#include "garment/pattern/sew_line.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "garment/pattern/equal_sides.h"
#include "garment/pattern/outline_crossing.h"

namespace ease {
namespace {

constexpr double kMillimetres = 1000.0;  // in a metre
constexpr int kSmoothings = 4;           // of an edge
constexpr double kCorner = 40.0;         // degrees: sharper bends are corners and stay
constexpr size_t kBend = 3;              // points on either side by which a bend is measured
constexpr double kStraight = 2.0;        // mm: legs of a dart are drawn straight that bend no further

/// Whether the line bends sharply at point i.
bool isCorner(const std::vector<PaperPoint>& points, size_t i) {
  const PaperPoint a = points[i] - points[i - std::min(i, kBend)],
                   b = points[std::min(i + kBend, points.size() - 1)] - points[i];
  return a.dot(b) < std::cos(kCorner * M_PI / 180.0) * a.norm() * b.norm();
}

/// Moves inner points but those that stay to the middle of their neighbours and themselves, again and again.
void smooth(int passes, const std::vector<char>& stays, std::vector<PaperPoint>& points) {
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<PaperPoint> before = points;
    for (size_t i = 1; i + 1 < points.size(); ++i)
      if (!stays[i]) points[i] = 0.25 * before[i - 1] + 0.5 * before[i] + 0.25 * before[i + 1];
  }
}

/// The points of every edge of the cut on the paper, mm, smoothed.
std::vector<std::vector<PaperPoint>> smoothEdges(const FlatPattern& pattern) {
  const std::vector<PieceEdge>& edges = pattern.cut.edges;
  std::vector<std::vector<PaperPoint>> points(edges.size());
  std::vector<std::vector<char>> corners(edges.size());
  for (size_t e = 0; e < edges.size(); ++e) {
    const Eigen::Matrix2d axes = paperAxes(pattern, edges[e].piece);
    for (const int v : edges[e].vertices) points[e].push_back(axes * pattern.x.row(v).head<2>().transpose());
    for (size_t i = 0; i < points[e].size(); ++i) corners[e].push_back(isCorner(points[e], i) ? 1 : 0);
  }
  for (size_t e = 0; e < edges.size(); ++e) {
    std::vector<char> stays(points[e].size(), 0);
    for (size_t i = 0; i < stays.size(); ++i)  // on both sides or on none
      stays[i] = corners[e][i] && (edges[e].partner < 0 || corners[edges[e].partner][stays.size() - 1 - i]);
    smooth(kSmoothings, stays, points[e]);
  }
  return points;
}

/// How far a line bends away from the straight one between its ends, mm.
double bendOf(const std::vector<PaperPoint>& points) {
  const PaperPoint along = (points.back() - points.front()).normalized();
  double bend = 0.0;
  for (const PaperPoint& p : points) {
    const PaperPoint x = p - points.front();
    bend = std::max(bend, std::abs(along.x() * x.y() - along.y() * x.x()));
  }
  return bend;
}

/// The edges of a sew line between which it crosses itself, in pairs.
std::vector<std::array<size_t, 2>> crossingEdges(const SewLine& line) {
  std::vector<size_t> edge_of_point;
  std::vector<int> outline;
  size_t count = 0;
  for (const SewnEdge& edge : line.edges) count += edge.points.size() - 1;
  Positions x = Positions::Zero(static_cast<int>(count), 3);
  for (size_t i = 0; i < line.edges.size(); ++i)
    for (size_t k = 0; k + 1 < line.edges[i].points.size(); ++k) {
      outline.push_back(static_cast<int>(outline.size()));
      x.row(outline.back()).head<2>() = line.edges[i].points[k];
      edge_of_point.push_back(i);
    }
  std::vector<std::array<size_t, 2>> edges;
  for (const auto& [a, b] : crossings(outline, x)) edges.push_back({edge_of_point[a], edge_of_point[b]});
  return edges;
}

/// Begins the line with an edge that is not the second leg of a dart, and draws legs straight from mouth to tip where
/// both hardly bend, or where the line would otherwise cross itself.
void straightenDarts(const CutGarment& cut, SewLine& line) {
  const int last = line.numbers.back();
  if (line.edges.front().is_dart && cut.edges[line.numbers.front()].partner == last) {
    std::rotate(line.edges.begin(), line.edges.begin() + 1, line.edges.end());
    std::rotate(line.numbers.begin(), line.numbers.begin() + 1, line.numbers.end());
  }
  const auto isFirstLeg = [&](size_t i) {
    return i + 1 < line.edges.size() && line.edges[i].is_dart &&
           cut.edges[line.numbers[i]].partner == line.numbers[i + 1];
  };
  const auto straighten = [&](size_t i) {
    for (SewnEdge* leg : {&line.edges[i], &line.edges[i + 1]}) leg->points = {leg->points.front(), leg->points.back()};
  };
  for (size_t i = 0; i < line.edges.size(); ++i) {
    if (!isFirstLeg(i)) continue;
    if (std::max(bendOf(line.edges[i].points), bendOf(line.edges[i + 1].points)) < kStraight) straighten(i);
    ++i;
  }
  for (const std::array<size_t, 2>& pair : crossingEdges(line))
    for (const size_t i : pair)
      if (line.edges[i].is_dart) straighten(isFirstLeg(i) ? i : i - 1);
}

}  // namespace

Eigen::Matrix2d paperAxes(const FlatPattern& pattern, int piece) {
  const double sign = pattern.pieces[piece].upside_down ? -kMillimetres : kMillimetres;
  Eigen::Matrix2d axes;
  axes << 0.0, sign, -sign, 0.0;
  return axes;
}

std::vector<SewLine> sewLines(const FlatPattern& pattern, const Allowances& allowances) {
  const std::vector<PieceEdge>& edges = pattern.cut.edges;
  std::vector<std::vector<PaperPoint>> points = smoothEdges(pattern);
  std::vector<SewLine> lines(pattern.cut.outlines.size());
  for (size_t p = 0; p < lines.size(); ++p)
    for (const int e : pattern.cut.outlines[p]) {
      SewnEdge drawn;
      drawn.points = std::move(points[e]);
      const auto named = allowances.by_name.find(edges[e].name);
      drawn.width = kMillimetres * (named != allowances.by_name.end() ? named->second : allowances.all);
      drawn.is_folded = edges[e].line < 0;
      drawn.is_dart = isDartLeg(pattern.cut, e);
      if (drawn.is_dart) drawn.width = 0.0;
      lines[p].edges.push_back(std::move(drawn));
      lines[p].numbers.push_back(e);
    }
  for (SewLine& line : lines) straightenDarts(pattern.cut, line);
  makeSidesEqual(pattern.cut, lines);
  return lines;
}

std::vector<double> drawnLengths(const CutGarment& cut, const std::vector<SewLine>& lines) {
  std::vector<double> lengths(cut.edges.size(), 0.0);
  for (const SewLine& line : lines)
    for (size_t i = 0; i < line.edges.size(); ++i)
      for (size_t k = 0; k + 1 < line.edges[i].points.size(); ++k)
        lengths[line.numbers[i]] += (line.edges[i].points[k + 1] - line.edges[i].points[k]).norm();
  return lengths;
}

PaperPoint pointAt(const FlatPattern& pattern, const SewnEdge& drawn, int edge, double share, PaperPoint& direction) {
  const std::vector<double>& shares = pattern.shares[edge];
  size_t i = 0;
  while (i + 2 < shares.size() && shares[i + 1] < share) ++i;
  const double part = std::clamp((share - shares[i]) / (shares[i + 1] - shares[i]), 0.0, 1.0);
  direction = (drawn.points[i + 1] - drawn.points[i]).normalized();
  return drawn.points[i] + part * (drawn.points[i + 1] - drawn.points[i]);
}

}  // namespace ease
