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
constexpr double kShortSeam = 0.05;  // m: shorter seams have no notches
// Longer seams have one, two or three places with notches, which are shares of their lengths.  No place is as far from
// one end as another from the other end: a side that is turned end for end does not match.
constexpr double kLongSeam = 0.15, kVeryLongSeam = 0.5;  // m
constexpr double kNearest = 0.012;                       // m, between two places, and to the mirror image of one
constexpr double kSmooth = 45.0;                         // degrees: where two edges meet with a smaller turn
constexpr double kFarthest = 1.5;                        // widths from a dart's mouth to the end of the allowance
constexpr double kSlack = 0.1;  // of the allowance's width, by which the cut line may be nearer or further
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

std::vector<double> placesOn(double length) {
  if (length < kShortSeam) return {};
  if (length < kLongSeam) return {0.4};
  if (length < kVeryLongSeam) return {0.3, 0.62};
  return {0.2, 0.45, 0.72};
}

/// An edge on which notches of a seam lie, at their shares of its length or, if it runs the other way, at 1 - share.
struct AlikeEdge {
  int edge;
  bool is_reversed;
};

/// The two sides of a seam, and those of the seam whose pieces are the mirror images of this one's.
std::vector<AlikeEdge> edgesAlike(const CutGarment& cut, const std::vector<int>& twin, int edge) {
  std::vector<AlikeEdge> alike = {{edge, false}};
  for (size_t i = 0; i < alike.size(); ++i)
    for (const int other : {cut.edges[alike[i].edge].partner, twin[alike[i].edge]}) {
      const auto is_known = [&](const AlikeEdge& known) { return known.edge == other; };
      if (other >= 0 && std::none_of(alike.begin(), alike.end(), is_known))
        alike.push_back({other, !alike[i].is_reversed});
    }
  return alike;
}

/// A mark where the seam between two other pieces ends on this one, such as that of a shoulder on a sleeve.
void addMeeting(const SewnEdge& before, const SewnEdge& after, DrawnPiece& piece) {
  const PaperPoint at = before.points.back(), in = (at - before.points[before.points.size() - 2]).normalized(),
                   out = (after.points[1] - at).normalized(), along = (in + out).normalized();
  if (in.dot(out) < std::cos(kSmooth * M_PI / 180.0)) return;
  const PaperPoint outward(along.y(), -along.x());
  const double widest = std::max(before.width, after.width), narrowest = std::min(before.width, after.width);
  const double width = widest > 0.0 ? reach(at, outward, piece.cut) : 0.0;
  if (width >= (1.0 - kSlack) * narrowest && width <= (1.0 + kSlack) * widest)
    piece.notches.push_back(notchBeyond(at, outward, width));
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

void addNotch(const PaperPoint& on_sew_line, const PaperPoint& outward, double width, DrawnPiece& piece) {
  const double to_cut = std::max(0.0, reach(on_sew_line, outward, piece.cut));
  if (to_cut <= kFarthest * width) piece.notches.push_back(notchBeyond(on_sew_line, outward, to_cut));
}

std::vector<std::vector<double>> seamNotches(const FlatPattern& pattern, const std::vector<SewLine>& lines,
                                             const MirrorPieces& mirror,
                                             const std::vector<std::vector<PaperPoint>>& cuts) {
  const CutGarment& cut = pattern.cut;
  std::vector<std::vector<double>> shares_of_edge(cut.edges.size());
  std::vector<char> is_done(cut.edges.size(), 0);
  for (const SeamSides& seam : pattern.seams) {
    if (is_done[seam.left] || isDartLeg(cut, seam.left)) continue;
    const std::vector<AlikeEdge> alike = edgesAlike(cut, mirror.twin, seam.left);
    const auto isBack = [&](const AlikeEdge& at) { return pattern.pieces[cut.edges[at.edge].piece].is_back; };
    const double apart =
        std::any_of(alike.begin(), alike.end(), isBack) ? 0.5e-3 * kGap / seam.rest_length : 0.0;  // of a double notch
    const auto hasPlace = [&](double share) {
      return std::all_of(alike.begin(), alike.end(), [&](const AlikeEdge& at) {
        if (mirror.image_of[cut.edges[at.edge].piece] >= 0) return true;  // cut from the other piece's drawing
        return notchAt(pattern, sideOf(pattern, lines, cuts, at.edge), at.is_reversed ? 1.0 - share : share)
            .has_value();
      });
    };
    std::vector<double> taken;
    const auto isTaken = [&](double share) {  // or its mirror image, so that the side could be turned end for end
      return std::any_of(taken.begin(), taken.end(), [&](double other) {
        return std::min(std::abs(share - other), std::abs(1.0 - share - other)) < kNearest / seam.rest_length;
      });
    };
    for (const double place : placesOn(seam.rest_length))
      for (const double move : kMoves) {
        std::vector<double> shares = {place + move - apart, place + move + apart};
        if (apart == 0.0) shares.pop_back();
        if (!std::all_of(shares.begin(), shares.end(), hasPlace) || isTaken(place + move)) continue;
        taken.push_back(place + move);
        for (const AlikeEdge& at : alike)
          for (const double share : shares) shares_of_edge[at.edge].push_back(at.is_reversed ? 1.0 - share : share);
        break;
      }
    for (const AlikeEdge& at : alike) is_done[at.edge] = 1;
  }
  return shares_of_edge;
}

void addSeamNotches(const FlatPattern& pattern, const std::vector<SewLine>& lines,
                    const std::vector<std::vector<PaperPoint>>& cuts,
                    const std::vector<std::vector<double>>& shares_of_edge, DrawnPiece& piece) {
  const SewLine& line = lines[piece.source];
  const auto isSewn = [&](size_t i) {
    return !line.edges[i].is_dart && pattern.cut.edges[line.numbers[i]].partner >= 0;
  };
  for (size_t i = 0; i < line.edges.size(); ++i) {
    for (const double share : shares_of_edge[line.numbers[i]])
      if (const auto notch = notchAt(pattern, sideOf(pattern, lines, cuts, line.numbers[i]), share))
        piece.notches.push_back(*notch);
    const size_t next = (i + 1) % line.edges.size();
    if (next != i && isSewn(i) && isSewn(next)) addMeeting(line.edges[i], line.edges[next], piece);
  }
}

}  // namespace ease
