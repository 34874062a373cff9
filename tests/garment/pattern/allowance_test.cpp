#include "garment/pattern/allowance.h"

#include <catch2/catch.hpp>

#include "garment/pattern/outline_crossing.h"

using namespace ease;

namespace {

double distanceTo(const PaperPoint& x, const std::vector<PaperPoint>& line, bool is_closed) {
  double nearest = INFINITY;
  for (size_t i = 0; i + (is_closed ? 0 : 1) < line.size(); ++i) {
    const PaperPoint &a = line[i], ab = line[(i + 1) % line.size()] - a;
    const double along = std::clamp(ab.dot(x - a) / ab.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (a + along * ab - x).norm());
  }
  return nearest;
}

void checkDoesNotCross(const std::vector<PaperPoint>& cut) {
  double s = 0.0, t = 0.0;
  for (size_t i = 0; i < cut.size(); ++i)
    for (size_t j = i + 2; j < cut.size(); ++j)
      if (i > 0 || j + 1 < cut.size())
        CHECK_FALSE(crossing(cut[i], cut[(i + 1) % cut.size()], cut[j], cut[(j + 1) % cut.size()], s, t));
}

/// Checks that the cut line is nowhere nearer to an edge than its width, and does not cross itself.
void checkCut(const std::vector<SewnEdge>& edges, const std::vector<PaperPoint>& cut) {
  for (const SewnEdge& edge : edges)
    for (const PaperPoint& x : cut)
      if (!edge.is_dart) CHECK(distanceTo(x, edge.points, false) > edge.width - 0.1);
  checkDoesNotCross(cut);
}

SewnEdge edge(const std::vector<PaperPoint>& points, double width, bool is_folded = false) {
  return {points, width, is_folded, false};
}

}  // namespace

TEST_CASE("a square has a square around it") {
  const std::vector<SewnEdge> edges = {edge({{0, 0}, {100, 0}}, 10), edge({{100, 0}, {100, 100}}, 10),
                                       edge({{100, 100}, {0, 100}}, 10), edge({{0, 100}, {0, 0}}, 10)};
  const std::vector<PaperPoint> cut = cutLine(edges);
  CHECK(areaWithin(cut) == Approx(120.0 * 120.0));
  checkCut(edges, cut);
}

TEST_CASE("a wide allowance that meets a narrow one with hardly a corner begins by a step") {
  for (const double neck : {0.0, 5.0}) {
    const std::vector<SewnEdge> edges = {
        edge({{0, 0}, {200, 0}}, 15), edge({{200, 0}, {200, 100}}, 15),
        edge({{200, 100}, {180, 108}, {160, 116}, {140, 124}, {120, 132}, {100, 140}}, 15),
        edge({{100, 140}, {75, 143}, {50, 145}, {25, 146}, {0, 146}}, neck, true), edge({{0, 146}, {0, 0}}, 15)};
    const std::vector<PaperPoint> cut = cutLine(edges);
    checkDoesNotCross(cut);
    for (size_t i = 0; i < cut.size(); ++i) {
      const PaperPoint a = cut[(i + 1) % cut.size()] - cut[i],
                       b = cut[(i + 2) % cut.size()] - cut[(i + 1) % cut.size()];
      CHECK(a.dot(b) > -0.5 * a.norm() * b.norm());  // nowhere does the line turn back
    }
  }
}

TEST_CASE("a wide hem folded up ends on the cut line of the sides, at corners of any angle") {
  for (const double flare : {-30.0, 0.0, 30.0}) {  // mm by which the hem is wider at each end than the waist
    const std::vector<SewnEdge> edges = {edge({{-flare, 0}, {100 + flare, 0}}, 30, true),
                                         edge({{100 + flare, 0}, {100, 200}}, 10), edge({{100, 200}, {0, 200}}, 10),
                                         edge({{0, 200}, {-flare, 0}}, 10)};
    const std::vector<PaperPoint> cut = cutLine(edges);
    const Bounds bounds = boundsOf(cut);
    CHECK(bounds.lower.y() == Approx(-30.0));
    for (const PaperPoint& x : cut) {
      if (x.y() > -29.9) continue;
      // Folded up, the corner of the hem lies on the cut line of the side.
      CHECK(distanceTo({x.x(), -x.y()}, cut, true) < 1e-6);
    }
  }
}

TEST_CASE("a sharp corner does not stick out") {
  const std::vector<SewnEdge> edges = {edge({{0, 0}, {200, 0}}, 10), edge({{200, 0}, {0, 40}}, 10),
                                       edge({{0, 40}, {0, 0}}, 10)};
  const std::vector<PaperPoint> cut = cutLine(edges);
  CHECK(boundsOf(cut).upper.x() <= 200.0 + 3.5 * 10.0 + 1e-9);
  CHECK(areaWithin(cut) > 4000.0);
}

TEST_CASE("an inward corner keeps its allowance, and the cut line does not cross itself") {
  const std::vector<SewnEdge> edges = {
      edge({{0, 0}, {100, 0}, {100, 100}, {60, 100}, {50, 50}, {40, 100}, {0, 100}, {0, 0}}, 10)};
  const std::vector<PaperPoint> cut = cutLine(edges);
  checkCut(edges, cut);
}

TEST_CASE("the cut line runs across the mouth of a dart as a roof on its axis") {
  SewnEdge leg, back;
  leg.points = {{55, 100}, {50, 40}};
  back.points = {{50, 40}, {45, 100}};
  leg.is_dart = back.is_dart = true;
  const std::vector<SewnEdge> edges = {
      edge({{0, 0}, {100, 0}}, 10),    edge({{100, 0}, {100, 100}}, 10), edge({{100, 100}, {55, 100}}, 10), leg, back,
      edge({{45, 100}, {0, 100}}, 10), edge({{0, 100}, {0, 0}}, 10)};
  const std::vector<PaperPoint> cut = cutLine(edges);
  checkCut(edges, cut);
  double highest = 0.0;
  for (const PaperPoint& x : cut)
    if (std::abs(x.x() - 50.0) < 1e-6) highest = std::max(highest, x.y());
  CHECK(highest > 110.0);
  CHECK(highest < 112.0);
}
