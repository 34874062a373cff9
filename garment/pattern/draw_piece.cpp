#include "garment/pattern/draw_piece.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "garment/pattern/notches.h"
#include "solver/mesh/segment.h"

namespace ease {
namespace {

constexpr double kDrillBeforeTip = 10.0;                                       // mm
constexpr double kNameBeyondTip = 8.0;                                         // mm, of a dart
constexpr double kGrainLength = 100.0;                                         // mm
constexpr double kNameHeight = 7.0, kTextHeight = 4.0, kSeamNameHeight = 2.8;  // mm

/// Letters of a text in UTF-8.
size_t lettersOf(const std::string& words) {
  return static_cast<size_t>(
      std::count_if(words.begin(), words.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// The point at a distance along a line from its beginning, mm, or its end where it is shorter.
PaperPoint pointAlong(const std::vector<PaperPoint>& line, double distance) {
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const PaperPoint step = line[i + 1] - line[i];
    if (step.norm() >= distance) return line[i] + distance * step.normalized();
    distance -= step.norm();
  }
  return line.back();
}

void addDarts(const FlatPattern& pattern, const SewLine& line, DrawnPiece& piece) {
  for (size_t i = 0; i + 1 < line.edges.size(); ++i) {
    if (!line.edges[i].is_dart || !line.edges[i + 1].is_dart) continue;
    const PaperPoint p = line.edges[i].points.front(), tip = line.edges[i].points.back(),
                     q = line.edges[i + 1].points.back();
    std::vector<PaperPoint> legs = line.edges[i].points;
    legs.insert(legs.end(), line.edges[i + 1].points.begin() + 1, line.edges[i + 1].points.end());
    piece.lines.push_back({Ink::inner, legs, false});
    const size_t n = line.edges.size();
    addNotch(p, (p - tip).normalized(), line.edges[(i + n - 1) % n].width, piece);
    addNotch(q, (q - tip).normalized(), line.edges[(i + 2) % n].width, piece);
    const std::vector<PaperPoint> back(line.edges[i].points.rbegin(), line.edges[i].points.rend());
    const PaperPoint hole =
        0.5 * (pointAlong(back, kDrillBeforeTip) + pointAlong(line.edges[i + 1].points, kDrillBeforeTip));
    piece.drills.push_back(hole);
    const PaperPoint onwards = (tip - hole).normalized();
    const std::string& name = pattern.cut.edges[line.numbers[i]].name;
    const double half = 0.5 * 0.62 * kSeamNameHeight * static_cast<double>(lettersOf(name)) * std::abs(onwards.x());
    piece.texts.push_back({tip + (kNameBeyondTip + half) * onwards - PaperPoint(0.0, 0.5 * kSeamNameHeight),
                           kSeamNameHeight, 0.0, name, true});
    ++i;
  }
}

/// How far a point lies inside a closed line, mm; negative outside.
double depthWithin(const PaperPoint& x, const std::vector<PaperPoint>& line) {
  double nearest = INFINITY;
  bool is_inside = false;
  for (size_t i = 0; i < line.size(); ++i) {
    const PaperPoint &a = line[i], &b = line[(i + 1) % line.size()];
    nearest = std::min(nearest, distanceToSegment(a, b, x));
    if ((a.y() > x.y()) != (b.y() > x.y()) && x.x() < a.x() + (x.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      is_inside = !is_inside;
  }
  return is_inside ? nearest : -nearest;
}

/// The point furthest from the outline, on a grid.
PaperPoint middleOf(const std::vector<PaperPoint>& sew) {
  const Bounds bounds = boundsOf(sew);
  constexpr int kSteps = 24;
  PaperPoint best = sew.front();
  double deepest = -INFINITY;
  for (int i = 1; i < kSteps; ++i)
    for (int j = 1; j < kSteps; ++j) {
      const PaperPoint x = bounds.lower + PaperPoint(i, j).cwiseProduct(bounds.upper - bounds.lower) / kSteps;
      const double depth = depthWithin(x, sew);
      if (depth <= deepest) continue;
      deepest = depth;
      best = x;
    }
  return best;
}

void addGrain(const PaperPoint& near, DrawnPiece& piece) {
  const double up = reach(near, {0.0, 1.0}, piece.sew), down = reach(near, {0.0, -1.0}, piece.sew);
  const double length = std::min(kGrainLength, 0.7 * (up + down));
  const PaperPoint middle = near + PaperPoint(0.0, 0.5 * (up - down));
  const PaperPoint top = middle + PaperPoint(0.0, 0.5 * length), bottom = middle - PaperPoint(0.0, 0.5 * length);
  piece.lines.push_back({Ink::grain, {bottom, top}, false});
  for (const auto& [end, sign] : {std::pair(top, -1.0), std::pair(bottom, 1.0)})
    piece.lines.push_back(
        {Ink::grain, {end + PaperPoint(-2.0, 5.0 * sign), end, end + PaperPoint(2.0, 5.0 * sign)}, false});
}

std::string cutText(const DrawnPiece& piece, double grain) {
  std::string text = piece.quantity == 1 ? "cut 1, this side up" : "cut 2, one of them mirrored";
  if (grain != 0.0)
    text += fmt::format(", grain turned {:.0f} deg {}", std::abs(grain) * 180.0 / M_PI, grain > 0.0 ? "left" : "right");
  return text;
}

/// A seam's name and to which piece it is sewn, by that piece's name, or by its number where there is less room;
/// `length`: the room, mm.
std::string seamWords(const FlatPattern& pattern, int number, const DrawnPiece& piece, const std::vector<int>& numbers,
                      double length) {
  const PieceEdge& edge = pattern.cut.edges[number];
  if (edge.partner < 0) return edge.name;
  const auto found = piece.mirror_edges.find(number);
  const PieceEdge* twin =
      found == piece.mirror_edges.end() || found->second < 0 ? nullptr : &pattern.cut.edges[found->second];
  const int other = pattern.cut.edges[edge.partner].piece;
  if (other == edge.piece) return edge.name;
  const auto fits = [&](const std::string& words) {
    return 0.6 * kSeamNameHeight * static_cast<double>(lettersOf(words)) <= length;
  };
  const std::string by_name =
      edge.name + " > " + (other == piece.mirror_image ? "its mirror image" : pattern.pieces[other].name);
  if (fits(by_name) && (piece.mirror_image < 0 || other == piece.mirror_image)) return by_name;
  std::string by_number = fmt::format("{} > {}", edge.name, numbers[other]);
  if (twin && twin->partner >= 0) {  // the other copy's edge here
    const std::string of_twin = fmt::format("{} > {}", twin->name, numbers[pattern.cut.edges[twin->partner].piece]);
    if (of_twin != by_number) by_number += " / " + of_twin;
  }
  return fits(by_number) ? by_number : edge.name;
}

/// Name, number and grain in the middle of the piece, names along the seams, and the width of their allowance where it
/// is not `usual`, mm.  `numbers`: of all pieces, as drawn.
void addWords(const FlatPattern& pattern, const SewLine& line, double usual, const std::vector<int>& numbers,
              DrawnPiece& piece) {
  const PaperPoint middle = middleOf(piece.sew);
  const double room = std::max(20.0, 2.0 * depthWithin(middle, piece.sew));
  const std::string number = fmt::format("piece {} of {}", piece.number, piece.count),
                    cut = cutText(piece, pattern.pieces[piece.source].grain);
  const double widest = std::max({0.62 * kNameHeight * static_cast<double>(lettersOf(piece.name)),
                                  0.62 * kTextHeight * static_cast<double>(std::max(number.size(), cut.size()))});
  const double scale = std::min(1.0, 0.8 * room / (widest + 12.0));
  const double shift = 0.5 * scale * widest + 8.0;
  addGrain(depthWithin(middle - PaperPoint(shift, 0.0), piece.sew) > 5.0 ? middle - PaperPoint(shift, 0.0) : middle,
           piece);
  piece.texts.push_back({middle + PaperPoint(0.0, 5.0 * scale), kNameHeight * scale, 0.0, piece.name, true});
  piece.texts.push_back({middle - PaperPoint(0.0, 4.0 * scale), kTextHeight * scale, 0.0, number});
  piece.texts.push_back({middle - PaperPoint(0.0, 11.0 * scale), kTextHeight * scale, 0.0, cut});
  for (size_t i = 0; i < line.edges.size(); ++i) {
    if (line.edges[i].is_dart) continue;
    PaperPoint along;
    const PaperPoint at = pointAt(pattern, line.edges[i], line.numbers[i], 0.5, along);
    double angle = std::atan2(along.y(), along.x()) * 180.0 / M_PI;
    const PaperPoint inward(-along.y(), along.x());
    const bool is_reversed = angle > 90.0 || angle <= -90.0;
    if (is_reversed) angle += angle > 0.0 ? -180.0 : 180.0;
    const double length = (line.edges[i].points.back() - line.edges[i].points.front()).norm();
    std::string words = seamWords(pattern, line.numbers[i], piece, numbers, length);
    if (std::abs(line.edges[i].width - usual) > 0.01) words += fmt::format(", {:.3g} mm", line.edges[i].width);
    piece.texts.push_back({at + inward * (is_reversed ? 2.0 + kSeamNameHeight : 2.0), kSeamNameHeight, angle, words});
  }
}

}  // namespace

std::vector<DrawnPiece> drawPieces(const FlatPattern& pattern, const Allowances& allowances) {
  std::vector<DrawnPiece> drawn;
  const std::vector<SewLine> lines = sewLines(pattern, allowances);
  for (int p = 0; p < pattern.cut.pieces.count; ++p) {
    DrawnPiece piece;
    piece.name = pattern.pieces[p].name;
    piece.source = p;
    piece.axes = paperAxes(pattern, p);
    for (const SewnEdge& edge : lines[p].edges)
      piece.sew.insert(piece.sew.end(), edge.points.begin(), edge.points.end() - 1);
    piece.cut = cutLine(lines[p].edges, "piece '" + piece.name + "'");
    drawn.push_back(std::move(piece));
  }
  std::vector<std::vector<PaperPoint>> cuts;
  for (const DrawnPiece& piece : drawn) cuts.push_back(piece.cut);
  const MirrorPieces mirror = mirrorPieces(lines);
  const std::vector<std::vector<double>> notches = seamNotches(pattern, lines, mirror, cuts);
  std::vector<int> numbers;  // from 1; of mirror images the same
  int count = 0;
  for (const int image_of : mirror.image_of) numbers.push_back(image_of < 0 ? ++count : numbers[image_of]);
  std::vector<DrawnPiece> pieces;
  for (size_t p = 0; p < drawn.size(); ++p) {
    if (mirror.image_of[p] >= 0) continue;
    DrawnPiece& piece = drawn[p];
    piece.number = numbers[p];
    piece.count = count;
    for (size_t q = p + 1; q < drawn.size(); ++q)
      if (mirror.image_of[q] == static_cast<int>(p)) {
        piece.quantity = 2;
        piece.mirrored = true;
        piece.mirror_image = static_cast<int>(q);
        piece.name += " / " + drawn[q].name;
        for (const int e : lines[p].numbers) piece.mirror_edges[e] = mirror.twin[e];
      }
    addSeamNotches(pattern, lines, cuts, notches, piece);
    addWords(pattern, lines[p], 1e3 * allowances.all, numbers, piece);
    addDarts(pattern, lines[p], piece);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace ease
