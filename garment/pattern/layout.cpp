#include "garment/pattern/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "solver/base/error.h"

namespace ease {
namespace {

constexpr double kWidestColumn = 4.0;  // mm
constexpr int kOrders = 300;           // of the pieces that are tried

/// The space that a piece takes, by columns from its left end; mm above its lower end.
struct Profile {
  std::vector<double> low, high;
  PaperPoint lower = PaperPoint::Zero();  // lower left corner of the piece
  double height = 0.0;
};

Profile profileOf(const std::vector<PaperPoint>& cut, bool is_turned, double gap, double column_width) {
  std::vector<PaperPoint> points = cut;
  if (is_turned)
    for (PaperPoint& p : points) p = -p;
  const Bounds bounds = boundsOf(points);
  Profile profile;
  profile.lower = bounds.lower - PaperPoint(0.5 * gap, 0.5 * gap);
  const PaperPoint size = bounds.upper - bounds.lower + PaperPoint(gap, gap);
  profile.height = size.y();
  const auto columns = static_cast<size_t>(std::ceil(size.x() / column_width - 1e-9));
  profile.low.assign(columns, std::numeric_limits<double>::infinity());
  profile.high.assign(columns, -std::numeric_limits<double>::infinity());
  for (size_t i = 0; i < points.size(); ++i) {
    PaperPoint a = points[i] - profile.lower, b = points[(i + 1) % points.size()] - profile.lower;
    if (a.x() > b.x()) std::swap(a, b);
    const double first = std::floor((a.x() - 0.5 * gap) / column_width),
                 last = std::floor((b.x() + 0.5 * gap) / column_width);
    for (double c = std::max(first, 0.0); c <= last && c < static_cast<double>(columns); c += 1.0) {
      const auto at = [&](double x) {
        const double along = b.x() > a.x() ? std::clamp((x - a.x()) / (b.x() - a.x()), 0.0, 1.0) : 0.0;
        return a.y() + along * (b.y() - a.y());
      };
      const double left = at(c * column_width - 0.5 * gap), right = at((c + 1) * column_width + 0.5 * gap);
      double low = std::min(left, right), high = std::max(left, right);
      if (b.x() - a.x() < 1e-9) {
        low = std::min(a.y(), b.y());
        high = std::max(a.y(), b.y());
      }
      const auto column = static_cast<size_t>(c);
      profile.low[column] = std::min(profile.low[column], low - 0.5 * gap);
      profile.high[column] = std::max(profile.high[column], high + 0.5 * gap);
    }
  }
  for (size_t c = 0; c < columns; ++c)
    if (profile.low[c] > profile.high[c]) profile.low[c] = profile.high[c] = 0.5 * profile.height;
  return profile;
}

/// Places the pieces in an order; profiles[2 p + turned].
Layout inOrder(const std::vector<size_t>& order, const std::vector<Profile>& profiles, size_t columns,
               double column_width) {
  Layout layout;
  std::vector<double> sky(columns, 0.0);
  for (const size_t p : order) {
    double best_top = std::numeric_limits<double>::infinity(), best_y = 0.0;
    size_t best_column = 0;
    bool best_turned = false;
    for (const bool turned : {false, true}) {
      const Profile& profile = profiles[2 * p + (turned ? 1 : 0)];
      for (size_t at = 0; at + profile.low.size() <= columns; ++at) {
        double y = 0.0;
        for (size_t c = 0; c < profile.low.size(); ++c) y = std::max(y, sky[at + c] - profile.low[c]);
        if (y + profile.height >= best_top - 1e-9) continue;
        best_top = y + profile.height;
        best_y = y;
        best_column = at;
        best_turned = turned;
      }
    }
    const Profile& profile = profiles[2 * p + (best_turned ? 1 : 0)];
    for (size_t c = 0; c < profile.low.size(); ++c)
      sky[best_column + c] = std::max(sky[best_column + c], best_y + profile.high[c]);
    layout.placements.push_back(
        {p, best_turned, PaperPoint(static_cast<double>(best_column) * column_width, best_y) - profile.lower});
    layout.length = std::max(layout.length, best_top);
    layout.width = std::max(layout.width, static_cast<double>(best_column + profile.low.size()) * column_width);
  }
  return layout;
}

}  // namespace

Layout layOut(const std::vector<DrawnPiece>& pieces, double cloth_width, double gap) {
  // At the selvedges no gap is needed: half of one lies beyond each.
  const auto columns = static_cast<size_t>(std::ceil((cloth_width + gap) / kWidestColumn));
  const double column_width = (cloth_width + gap) / static_cast<double>(columns);
  std::vector<Profile> profiles;
  for (const DrawnPiece& piece : pieces)
    for (const bool turned : {false, true}) {
      profiles.push_back(profileOf(piece.cut, turned, gap, column_width));
      const Bounds bounds = boundsOf(piece.cut);
      if (profiles.back().low.size() > columns)
        throw InputError(fmt::format(
            "fabric_width = {:g}: piece '{}' is {:.3f} m wide with its allowance, across the grain: expected wider "
            "fabric, or a seam that divides the piece",
            1e-3 * cloth_width, piece.name, 1e-3 * (bounds.upper.x() - bounds.lower.x())));
    }
  std::vector<size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t p, size_t q) { return profiles[2 * p].height > profiles[2 * q].height; });
  Layout best = inOrder(order, profiles, columns, column_width);
  std::mt19937 random(1);
  for (int trial = 1; trial < kOrders; ++trial) {
    for (size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random() % (i + 1)]);
    Layout layout = inOrder(order, profiles, columns, column_width);
    if (layout.length < best.length - 1e-9) best = std::move(layout);
  }
  return best;
}

}  // namespace ease
