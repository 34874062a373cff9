#include "garment/pattern/piece_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace ease {
namespace {

constexpr double kSmallestArea = 0.001;  // m^2
constexpr double kNarrowest = 0.01;      // m: 2 area / length of the outline, which is the width of a long strip

/// The names of the seams around a piece, in quotes.
std::string seamsAround(const FlatPattern& pattern, size_t piece) {
  std::set<std::string> names;
  for (const int e : pattern.cut.outlines[piece])
    if (const PieceEdge& edge = pattern.cut.edges[e]; edge.line >= 0 && !isDartLeg(pattern.cut, e))
      names.insert(edge.name);
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "'" : ", '") + name + "'";
  return list;
}

/// Length of a piece's outline on the paper without the legs of its darts, m.
double outlineLength(const FlatPattern& pattern, size_t piece) {
  double length = 0.0;
  for (const int e : pattern.cut.outlines[piece])
    if (!isDartLeg(pattern.cut, e)) length += lengthOf(pattern.cut.edges[e].vertices, pattern.x);
  return length;
}

}  // namespace

std::vector<double> widthsAcross(const FlatPattern& pattern) {
  std::vector<double> low(pattern.pieces.size(), std::numeric_limits<double>::infinity()), widths(low.size(), 0.0);
  for (const PieceEdge& edge : pattern.cut.edges)
    for (const int v : edge.vertices) low[edge.piece] = std::min(low[edge.piece], pattern.x(v, 1));
  for (const PieceEdge& edge : pattern.cut.edges)
    for (const int v : edge.vertices)
      widths[edge.piece] = std::max(widths[edge.piece], pattern.x(v, 1) - low[edge.piece]);
  return widths;
}

std::vector<std::string> pieceWarnings(const FlatPattern& pattern, const StrainLimits& limits) {
  std::vector<std::string> warnings;
  for (size_t p = 0; p < pattern.pieces.size(); ++p) {
    const FlatPiece& piece = pattern.pieces[p];
    const double width = 2.0 * piece.strain.area / outlineLength(pattern, p);
    if (piece.strain.area < kSmallestArea || width < kNarrowest) {
      const std::string seams = seamsAround(pattern, p);
      warnings.push_back(
          fmt::format("piece '{}' is too small to sew: {:.1f} cm^2, {:.1f} cm wide in the mean{}", piece.name,
                      1e4 * piece.strain.area, 100 * width,
                      seams.empty() ? "" : fmt::format(", between the seams {}: move one of them", seams)));
      continue;
    }
    if (piece.crosses_itself)
      warnings.push_back(
          fmt::format("piece '{}' overlaps itself when flat and cannot be cut: give it one more seam", piece.name));
    if (!keeps(piece.strain, limits))
      warnings.push_back(fmt::format(
          "piece '{}': 98 % of its area needs threads to stretch by up to {:.1f} %, over thread_limit = {:g} % on "
          "{:.1f} % "
          "of it, and 99 % needs shear of up to {:.1f} degrees: {}; add a [[garment.seam]] through it",
          piece.name, 100 * piece.strain.thread_p98, 100 * limits.thread, 100 * piece.strain.thread_over_share,
          piece.strain.shear_p99 * 180 / M_PI,
          piece.darts > 0 ? "its darts do not reach the limits" : "no dart that was tried reaches the limits"));
  }
  return warnings;
}

}  // namespace ease
