#include "garment/pattern/notches.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "garment/pattern/outline_crossing.h"

namespace ease {
namespace {

constexpr double kDepth = 5.0;       // mm
constexpr double kMinDepth = 2.0;    // mm; without allowance a notch is a mark on the piece
constexpr double kGap = 8.0;         // mm between the two of a double notch
constexpr double kLongSeam = 0.15;   // m: longer seams have two places with notches
constexpr double kShortSeam = 0.05;  // m: shorter ones have none
constexpr double kSlack = 0.1;       // of the allowance's width, by which the cut line may be nearer or further
// How far a notch may move along its seam to where both sides have an allowance, as shares of the seam.
constexpr double kMoves[] = {0.0, 0.04, -0.04, 0.08, -0.08, 0.12, -0.12, 0.16, -0.16};

/// One side of a seam as it is drawn.
struct Side {
  const SewnEdge& edge;
  int number;  // of CutGarment::edges
  const std::vector<PaperPoint>& cut;
};

Side sideOf(const FlatPattern& pattern, const std::vector<SewLine>& lines,
            const std::vector<std::vector<PaperPoint>>& cuts, int edge) {
  const int piece = pattern.cut.edges[edge].piece;
  const std::vector<int>& numbers = lines[piece].numbers;
  const auto at = std::find(numbers.begin(), numbers.end(), edge) - numbers.begin();
  return {lines[piece].edges[at], edge, cuts[piece]};
}

/// A notch at the end of an allowance of this width, mm.
Notch notchBeyond(const PaperPoint& on_sew_line, const PaperPoint& outward, double width) {
  return {on_sew_line + width * outward, -outward, std::max(kMinDepth, std::min(kDepth, 0.6 * width))};
}

/// A notch at a share of the side's length; none where the cut line is not where the allowance should end.
std::optional<Notch> notchAt(const FlatPattern& pattern, const Side& side, double share) {
  PaperPoint along;
  const PaperPoint at = pointAt(pattern, side.edge, side.number, share, along), outward(along.y(), -along.x());
  double width = 0.0;
  if (side.edge.width > 0.0) {
    width = reach(at, outward, side.cut);
    if (std::abs(width - side.edge.width) > kSlack * side.edge.width) return std::nullopt;
  }
  return notchBeyond(at, outward, width);
}

/// Notches of a side at these shares of its length; none if one of them has no place on this or on the other side.
std::vector<Notch> notchesAt(const FlatPattern& pattern, const Side& side, const Side& other,
                             const std::vector<double>& shares) {
  std::vector<Notch> notches;
  for (const double share : shares) {
    const std::optional<Notch> here = notchAt(pattern, side, share), there = notchAt(pattern, other, 1.0 - share);
    if (!here || !there) return {};
    notches.push_back(*here);
  }
  return notches;
}

bool isBack(const FlatPattern& pattern, int edge) {
  return pattern.pieces[pattern.cut.edges[edge].piece].name.find("back") != std::string::npos;
}

}  // namespace

double reach(const PaperPoint& from, const PaperPoint& direction, const std::vector<PaperPoint>& line) {
  double nearest = -1.0, s = 0.0, t = 0.0;
  const PaperPoint to = from + 1e4 * direction;
  for (size_t i = 0; i < line.size(); ++i)
    if (crossing(from, to, line[i], line[(i + 1) % line.size()], s, t) && (nearest < 0.0 || 1e4 * s < nearest))
      nearest = 1e4 * s;
  return nearest;
}

void addNotch(const PaperPoint& on_sew_line, const PaperPoint& outward, DrawnPiece& piece) {
  piece.notches.push_back(notchBeyond(on_sew_line, outward, std::max(0.0, reach(on_sew_line, outward, piece.cut))));
}

void addSeamNotches(const FlatPattern& pattern, const std::vector<SewLine>& lines,
                    const std::vector<std::vector<PaperPoint>>& cuts, DrawnPiece& piece) {
  const SewLine& line = lines[piece.source];
  for (size_t i = 0; i < line.edges.size(); ++i) {
    const int e = line.numbers[i], partner = pattern.cut.edges[e].partner;
    if (partner < 0 || line.edges[i].is_dart) continue;
    const auto seam = std::find_if(pattern.seams.begin(), pattern.seams.end(),
                                   [&](const SeamSides& s) { return s.left == std::min(e, partner); });
    if (seam->rest_length < kShortSeam) continue;
    const bool is_double = isBack(pattern, e) || isBack(pattern, partner);
    const double apart = is_double ? 0.5e-3 * kGap / seam->rest_length : 0.0;
    const Side side = sideOf(pattern, lines, cuts, e), other = sideOf(pattern, lines, cuts, partner);
    const double sign = e < partner ? 1.0 : -1.0;  // both sides move a notch to the same place
    for (const double place :
         seam->rest_length > kLongSeam ? std::vector<double>{1.0 / 3.0, 2.0 / 3.0} : std::vector<double>{0.5})
      for (const double move : kMoves) {
        const double share = place + sign * move;
        const std::vector<Notch> notches =
            notchesAt(pattern, side, other,
                      is_double ? std::vector<double>{share - apart, share + apart} : std::vector<double>{share});
        piece.notches.insert(piece.notches.end(), notches.begin(), notches.end());
        if (!notches.empty()) break;
      }
  }
}

}  // namespace ease
