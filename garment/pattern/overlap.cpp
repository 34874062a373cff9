#include "garment/pattern/overlap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "garment/pattern/dart_trial.h"
#include "garment/pattern/dart_ways.h"
#include "garment/pattern/outline_crossing.h"
#include "solver/base/parallel.h"

namespace ease {
namespace {

constexpr int kMaxCuts = 8;
constexpr int kIterations = 120;  // of the flattening by which overlaps are found
constexpr double kMinArc = 0.06;  // m: an outline that crosses itself within that length is crumpled, not too large

/// A flat outline and the length along it, m: n + 1 values for n vertices.
struct Outline {
  std::vector<int> vertices;
  std::vector<double> along;

  double length() const { return along.back(); }
  /// The vertex nearest to a place along the outline, which may lie beyond its end.
  int at(double place) const {
    const double within = std::fmod(place, length());
    const size_t i = std::lower_bound(along.begin(), along.end(), within) - along.begin();
    return vertices[i % vertices.size()];
  }
};

Outline flatOutline(const PieceMesh& part, const Positions& x) {
  Outline outline{buildTopology(part.mesh, "a pattern piece").boundary_loops.front(), {0.0}};
  const size_t n = outline.vertices.size();
  for (size_t i = 0; i < n; ++i)
    outline.along.push_back(outline.along.back() +
                            (x.row(outline.vertices[(i + 1) % n]) - x.row(outline.vertices[i])).norm());
  return outline;
}

/// The cut that parts what overlaps, by the part's vertices; empty where nothing does or no cut was found.
std::vector<int> cutThrough(const PieceMesh& part, const FlatSettings& settings) {
  const Positions x = flattenPart(part, {}, settings, kIterations).x;
  const Outline outline = flatOutline(part, x);
  double shortest = outline.length(), middle = -1.0;
  for (const auto& [i, j] : crossings(outline.vertices, x)) {
    const double inner = outline.along[j] - outline.along[i], outer = outline.length() - inner;
    if (std::min(inner, outer) < kMinArc || std::min(inner, outer) >= shortest) continue;
    shortest = std::min(inner, outer);
    middle = inner <= outer ? outline.along[i] + 0.5 * inner : outline.along[j] + 0.5 * outer;
  }
  if (middle < 0.0) return {};
  const int from = outline.at(middle), to = outline.at(middle + 0.5 * outline.length());
  const PartEdges edges(part);
  std::vector<char> blocked = edges.isOutline();
  blocked[to] = 0;
  const std::vector<int> way = edges.straightWay(from, to, x, blocked);
  return way.size() > 2 ? way : std::vector<int>{};
}

/// The seams of lines but for darts, which end where neither the garment nor another line does.
std::vector<Seam> dividingSeams(const std::vector<CutLine>& lines, const Topology& topology, int vertices) {
  std::vector<int> lines_at(vertices, 0);
  for (const std::vector<int>& loop : topology.boundary_loops)
    for (const int v : loop) ++lines_at[v];
  for (const CutLine& line : lines)
    for (const int v : line.seam.vertices) ++lines_at[v];
  std::vector<Seam> seams;
  for (const CutLine& line : lines)
    if (line.seam.is_closed || lines_at[line.seam.vertices.back()] > 1) seams.push_back(line.seam);
  return seams;
}

}  // namespace

std::vector<CutLine> withoutOverlaps(const RestGarment& garment, const std::vector<CutLine>& lines,
                                     const FlatSettings& settings) {
  std::vector<CutLine> all = lines;
  const Topology topology = buildTopology(garment.mesh, "the garment");
  for (int round = 0; round < kMaxCuts; ++round) {
    const Pieces pieces =
        cutIntoPieces(garment.mesh, dividingSeams(all, topology, static_cast<int>(garment.mesh.positions.rows())));
    std::vector<std::vector<int>> cuts(pieces.count);
    parallelFor(pieces.count, 1, [&](int p) {
      const PieceMesh part = partOf(garment, pieces, p);
      cuts[p] = cutThrough(part, settings);
      for (int& v : cuts[p]) v = part.garment_vertex[v];
    });
    const size_t before = all.size();
    for (const std::vector<int>& cut : cuts) {
      if (cut.empty()) continue;
      const auto number =
          1 + std::count_if(all.begin(), all.end(), [](const CutLine& line) { return line.kind == LineKind::opened; });
      all.push_back({{fmt::format("opening {}", number), cut, false}, LineKind::opened});
    }
    if (all.size() == before) break;
  }
  return all;
}

}  // namespace ease
