#include "garment/pattern/allowance.h"

#include <cmath>
#include <optional>

#include "garment/pattern/outer_boundary.h"
#include "solver/base/error.h"
#include "solver/base/joined.h"

namespace ease {
namespace {

constexpr double kMitre = 3.5;     // widths from the corner, at most
constexpr double kFold = 2.2;      // widths from the corner that a folded allowance may end at, at most
constexpr double kSharp = 75.0;    // degrees: corners below have both allowances mirrored
constexpr double kStraight = 2.0;  // degrees: an edge that goes on like this has no corner
constexpr double kGentle = 50.0;   // degrees: where edges turn less, another width begins by a step
constexpr double kSpike = -0.985;  // cosine of the turn, 170 degrees, from which a point is a spike
constexpr double kAlike = 0.5;     // mm: widths that differ less count as one

PaperPoint unit(const PaperPoint& p) {
  return p.normalized();
}

PaperPoint outward(const PaperPoint& direction) {  // of a counter-clockwise outline
  return {direction.y(), -direction.x()};
}

double cross(const PaperPoint& p, const PaperPoint& q) {
  return p.x() * q.y() - p.y() * q.x();
}

/// Where the line through p along d meets that through q along e; nothing if they are nearly parallel.
std::optional<PaperPoint> meeting(const PaperPoint& p, const PaperPoint& d, const PaperPoint& q, const PaperPoint& e) {
  const double det = cross(d, e);
  if (std::abs(det) < 1e-3) return {};
  return p + cross(q - p, e) / det * d;
}

PaperPoint mirrored(const PaperPoint& d, const PaperPoint& line) {
  return 2.0 * d.dot(line) * line - d;
}

/// Direction of an edge at its end or start: over at least 5 mm of it, so that one short step does not decide.
PaperPoint directionAt(const SewnEdge& edge, bool at_end) {
  const std::vector<PaperPoint>& p = edge.points;
  const PaperPoint corner = at_end ? p.back() : p.front();
  PaperPoint other = corner;
  for (size_t i = 1; i < p.size(); ++i) {
    other = at_end ? p[p.size() - 1 - i] : p[i];
    if ((other - corner).norm() >= 5.0) break;
  }
  return at_end ? unit(corner - other) : unit(other - corner);
}

/// A corner of the outline.
struct Corner {
  PaperPoint c, a, b;  // the corner, directions of the edge before and of that after
  double wa, wb;
  PaperPoint offsetA() const { return c + wa * outward(a); }
  PaperPoint offsetB() const { return c + wb * outward(b); }
};

void addMitre(const Corner& k, std::vector<PaperPoint>& line) {
  const auto m = meeting(k.offsetA(), k.a, k.offsetB(), k.b);
  const double most = kMitre * std::max(k.wa, k.wb);
  line.push_back(k.offsetA());
  if (m && (*m - k.c).norm() <= most)
    line.back() = *m;
  else if (m && cross(k.a, k.b) > 0.0) {  // cut off
    const auto towards = [&](const PaperPoint& offset, double width) -> PaperPoint {
      return offset + unit(*m - offset) * std::min(std::sqrt(most * most - width * width), (*m - offset).norm());
    };
    line.back() = towards(k.offsetA(), k.wa);
    line.push_back(towards(k.offsetB(), k.wb));
  } else {
    line.push_back(k.offsetB());
  }
}

/// Ends the allowance of A where the folded one ends on the cut line of B.  Returns whether it could.
bool addMirror(const Corner& k, std::vector<PaperPoint>& line) {
  const auto p = meeting(k.c, k.a, k.offsetB(), k.b);
  if (!p) return false;
  const auto q = meeting(*p, mirrored(k.b, k.a), k.offsetA(), k.a);
  const double most = kFold * std::max(k.wa, k.wb);
  if (!q || (*q - k.c).norm() > most || (*p - k.c).norm() > most) return false;
  line.push_back(*q);
  line.push_back(*p);
  return true;
}

/// The corner seen in a mirror: A and B change places.
Corner reversed(const Corner& k) {
  return {{-k.c.x(), k.c.y()}, {k.b.x(), -k.b.y()}, {k.a.x(), -k.a.y()}, k.wb, k.wa};
}

void addCorner(const SewnEdge& before, const SewnEdge& after, std::vector<PaperPoint>& line) {
  const Corner k{before.points.back(), directionAt(before, true), directionAt(after, false), before.width, after.width};
  const double turn = std::atan2(cross(k.a, k.b), k.a.dot(k.b)) * 180.0 / M_PI;  // left turns are positive
  if (std::abs(turn) < kStraight || (turn > 0.0 && turn < kGentle && std::abs(k.wa - k.wb) > kAlike)) {
    line.push_back(k.offsetA());
    line.push_back(k.offsetB());
    return;
  }
  if (turn < 0.0) {  // an inward corner: by way of the corner itself, so that no allowance becomes narrower
    line.push_back(k.offsetA());
    line.push_back(k.c);
    line.push_back(k.offsetB());
    return;
  }
  if (before.is_folded && !after.is_folded && addMirror(k, line)) return;
  if (after.is_folded && !before.is_folded) {
    std::vector<PaperPoint> other;
    if (addMirror(reversed(k), other)) {
      for (auto p = other.rbegin(); p != other.rend(); ++p) line.push_back({-p->x(), p->y()});
      return;
    }
  }
  std::vector<PaperPoint> first, second;
  if (180.0 - turn < kSharp && addMirror(k, first) && addMirror(reversed(k), second)) {
    for (PaperPoint& p : second) p.x() = -p.x();
    const auto middle = meeting(first[0], first[1] - first[0], second[0], second[1] - second[0]);
    if (middle && (*middle - k.c).norm() < kMitre * std::max(k.wa, k.wb)) {
      line.push_back(first[0]);
      line.push_back(*middle);
      line.push_back(second[0]);
      return;
    }
  }
  addMitre(k, line);
}

/// The cut line across the mouth of a dart with legs from p to the tip and back to q.
void addMouth(const SewnEdge& before, const SewnEdge& leg, const SewnEdge& back, const SewnEdge& after,
              std::vector<PaperPoint>& line) {
  const PaperPoint p = leg.points.front(), tip = leg.points.back(), q = back.points.back();
  const PaperPoint a = directionAt(before, true), b = directionAt(after, false);
  const PaperPoint middle = 0.5 * (p + q), axis = unit(middle - tip);
  const PaperPoint offset_a = p + before.width * outward(a), offset_b = q + after.width * outward(b);
  const PaperPoint leg_a = unit(p - tip), leg_b = unit(q - tip);
  // Where the cut lines of the seam meet the legs' lines; folded to the side of A, both halves of the dart lie on that
  // of A, so that the roof is its mirror image in leg A, and in the axis.
  const auto onLeg = [&](const PaperPoint& corner, const PaperPoint& leg_direction, const PaperPoint& offset,
                         const PaperPoint& along, double width) -> PaperPoint {
    const auto met = meeting(corner, leg_direction, offset, along);
    return met && (*met - corner).norm() <= kFold * width ? *met : offset;
  };
  const PaperPoint on_a = onLeg(p, leg_a, offset_a, a, before.width), on_b = onLeg(q, leg_b, offset_b, b, after.width);
  const bool folds_to_a = std::abs(a.dot(leg_a)) < std::abs(b.dot(leg_b));  // to where the seam is squarer
  const auto ridge =
      folds_to_a ? meeting(on_a, mirrored(a, leg_a), middle, axis) : meeting(on_b, mirrored(b, leg_b), middle, axis);
  line.push_back(on_a);
  if (ridge && (*ridge - middle).dot(axis) > 0.0 &&
      (*ridge - middle).norm() < 0.5 * (p - q).norm() + kFold * std::max(before.width, after.width))
    line.push_back(*ridge);
  line.push_back(on_b);
}

/// The offset line of an edge without its ends.
void addInner(const SewnEdge& edge, std::vector<PaperPoint>& line) {
  const std::vector<PaperPoint>& p = edge.points;
  for (size_t i = 1; i + 1 < p.size(); ++i) {
    const PaperPoint a = unit(p[i] - p[i - 1]), b = unit(p[i + 1] - p[i]);
    const Corner k{p[i], a, b, edge.width, edge.width};
    if (cross(a, b) >= 0.0) {
      addMitre(k, line);
    } else if (a.dot(b) > 0.9) {  // a bend inwards: both offsets meet before the corner's
      line.push_back(k.offsetA() + 0.5 * (k.offsetB() - k.offsetA()));
    } else {
      line.push_back(k.offsetA());
      line.push_back(k.c);
      line.push_back(k.offsetB());
    }
  }
}

/// Drops points at which a closed line goes back along itself: what lies between has no area.
void dropSpikes(std::vector<PaperPoint>& line) {
  for (size_t i = 0; i < line.size() && line.size() > 3;) {
    const size_t n = line.size();
    const PaperPoint there = line[(i + 1) % n] - line[i], back = line[i] - line[(i + n - 1) % n];
    if (there.dot(back) >= kSpike * there.norm() * back.norm()) {
      ++i;
      continue;
    }
    line.erase(line.begin() + static_cast<std::ptrdiff_t>(i));
    i -= std::min<size_t>(i, 1);
  }
}

}  // namespace

std::vector<PaperPoint> cutLine(const std::vector<SewnEdge>& edges, const std::string& name) {
  std::vector<PaperPoint> line;
  const size_t n = edges.size();
  if (n == 1) {  // one edge all around
    addInner(edges.front(), line);
    addCorner(edges.front(), edges.front(), line);
  }
  for (size_t e = 0; e < n && n > 1; ++e) {
    const SewnEdge &edge = edges[e], &next = edges[(e + 1) % n];
    if (edge.is_dart) continue;
    addInner(edge, line);
    if (next.is_dart)
      addMouth(edge, next, edges[(e + 2) % n], edges[(e + 3) % n], line);
    else
      addCorner(edge, next, line);
  }
  std::vector<PaperPoint> outside = outerBoundary(line);
  dropSpikes(outside);
  if (outside.size() < 3) {
    double widest = 0.0;
    for (const SewnEdge& edge : edges) widest = std::max(widest, edge.width);
    throw InputError(joined("allowance: that of ", name, ", up to ", widest,
                            " mm wide, leaves no cut line around it: expected a narrower one"));
  }
  return outside;
}

}  // namespace ease
