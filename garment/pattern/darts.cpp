#include "garment/pattern/darts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include "garment/pattern/dart_trial.h"
#include "solver/base/parallel.h"

namespace ease {
namespace {

constexpr int kCandidates = 40;        // tips that are tried at a time
constexpr double kMinLength = 0.03;    // m: darts are at least this long
constexpr double kMinGain = 0.07;      // share of what is still bad by which a dart must lessen it
constexpr double kMirrorReach = 0.02;  // m
constexpr int kTrialIterations = 40;
constexpr int kIterations = 120;  // with the darts found so far
constexpr int kRefused = 4;       // best candidates that are flattened further before none is taken

/// Shortest ways from the outline into a part.
struct Ways {
  std::vector<double> length;  // by vertex, m
  std::vector<int> before;     // by vertex; -1 on the outline
};

/// The edges of a part and which of its vertices a dart may not touch again.
class Inside {
 public:
  explicit Inside(const Part& part) : neighbours_(part.mesh.positions.rows()) {
    const Topology topology = buildTopology(part.mesh, "a pattern piece");
    is_outline_.assign(neighbours_.size(), 0);
    for (const Edge& edge : topology.edges) {
      const int t = edge.triangle[0];
      const double length = edgeLengths(part.rest_edges[t])[cornerOf(part.mesh.triangles, t, edge.opposite[0])];
      if (edge.isBoundary())
        for (const int v : edge.vertex) is_outline_[v] = 1;
      neighbours_[edge.vertex[0]].emplace_back(edge.vertex[1], length);
      neighbours_[edge.vertex[1]].emplace_back(edge.vertex[0], length);
    }
  }

  /// From all vertices with `starts`, over vertices without `taken`.
  Ways waysFrom(const std::vector<char>& starts, const std::vector<char>& taken) const {
    Ways ways{std::vector<double>(neighbours_.size(), std::numeric_limits<double>::infinity()),
              std::vector<int>(neighbours_.size(), -1)};
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    for (size_t v = 0; v < starts.size(); ++v)
      if (starts[v]) {
        ways.length[v] = 0.0;
        front.push({0.0, static_cast<int>(v)});
      }
    while (!front.empty()) {
      const auto [length, v] = front.top();
      front.pop();
      if (length > ways.length[v]) continue;
      for (const auto& [w, edge] : neighbours_[v]) {
        if (taken[w] || length + edge >= ways.length[w]) continue;
        ways.length[w] = length + edge;
        ways.before[w] = v;
        front.push({ways.length[w], w});
      }
    }
    return ways;
  }

  const std::vector<char>& isOutline() const { return is_outline_; }

 private:
  std::vector<std::vector<std::pair<int, double>>> neighbours_;
  std::vector<char> is_outline_;
};

std::vector<int> chainTo(int tip, const Ways& ways) {
  std::vector<int> chain;
  for (int v = tip; v >= 0; v = ways.before[v]) chain.push_back(v);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

double straightness(const std::vector<int>& chain, const Positions& x, double length) {
  return (x.row(chain.back()) - x.row(chain.front())).norm() / std::max(length, 1e-12);
}

/// Tips of darts spread over a part: each as far as possible from those before it.
std::vector<int> spreadTips(const Ways& ways, const Positions& x) {
  std::vector<int> tips;
  std::vector<double> distance(ways.length.size(), std::numeric_limits<double>::infinity());
  for (int k = 0; k < kCandidates; ++k) {
    int best = -1;
    for (size_t v = 0; v < distance.size(); ++v) {
      if (!std::isfinite(ways.length[v]) || ways.length[v] < kMinLength) continue;
      const double now = k == 0 ? ways.length[v] : distance[v];
      if (now > 0.0 && (best < 0 || now > (k == 0 ? ways.length[best] : distance[best]))) best = static_cast<int>(v);
    }
    if (best < 0) break;
    tips.push_back(best);
    for (size_t v = 0; v < distance.size(); ++v)
      distance[v] = std::min(distance[v], (x.row(static_cast<int>(v)) - x.row(best)).norm());
  }
  return tips;
}

/// The darts of one piece, found one after the other.
class DartSearch {
 public:
  DartSearch(const Part& part, const FlatSettings& settings, const std::vector<std::vector<Vec3>>& others)
      : part_(part), settings_(settings), inside_(part), others_(others), taken_(part.mesh.positions.rows(), 0) {}

  std::vector<Seam> run(int most) {
    Trial now = flattenPart(part_, {}, settings_, kIterations);
    part_.x = now.x;
    std::vector<Seam> darts;
    while (static_cast<int>(darts.size()) < most && !keeps(now.strain, settings_.limits)) {
      std::vector<Seam> candidates = candidatesNow();
      std::vector<Trial> trials(candidates.size());
      std::vector<double> lengths(candidates.size());
      parallelFor(static_cast<int>(candidates.size()), 1, [&](int k) {
        std::vector<Seam> with = darts;
        with.push_back(candidates[k]);
        trials[k] = flattenPart(part_, with, settings_, kTrialIterations);
        lengths[k] = lengthOf(candidates[k].vertices, part_.mesh.positions);
      });
      if (!takeBest(candidates, trials, lengths, darts, now)) break;
    }
    return darts;
  }

 private:
  /// Adds the candidate that gains most for its length; returns false where none gains enough.
  bool takeBest(const std::vector<Seam>& candidates, const std::vector<Trial>& trials,
                const std::vector<double>& lengths, std::vector<Seam>& darts, Trial& now) {
    const double least = kMinGain * now.badness.all();
    std::vector<std::pair<double, size_t>> by_rate;  // gain per length, negative, so that the best comes first
    for (size_t k = 0; k < candidates.size(); ++k)
      if (const double gain = now.badness.all() - trials[k].badness.all(); trials[k].is_sound && gain >= least)
        by_rate.emplace_back(-gain / lengths[k], k);
    std::sort(by_rate.begin(), by_rate.end());
    for (size_t k = 0; k < std::min<size_t>(by_rate.size(), kRefused); ++k) {
      darts.push_back(candidates[by_rate[k].second]);
      const Trial next = flattenPart(part_, darts, settings_, kIterations);
      if (next.is_sound && now.badness.all() - next.badness.all() >= least) {
        for (const int v : darts.back().vertices) taken_[v] = 1;
        others_.push_back(positionsOf(darts.back().vertices, part_.mesh.positions));
        now = next;
        part_.x = now.x;
        return true;
      }
      darts.pop_back();
    }
    return false;
  }

  /// Shortest darts to tips spread over the part, and the mirror images of darts on the wearer's other side, which
  /// come first so that they win where they gain as much.
  std::vector<Seam> candidatesNow() const {
    std::vector<char> starts = inside_.isOutline();
    for (size_t v = 0; v < starts.size(); ++v)
      if (taken_[v]) starts[v] = 0;
    std::vector<char> blocked = inside_.isOutline();
    for (size_t v = 0; v < blocked.size(); ++v)
      if (taken_[v]) blocked[v] = 1;
    const Ways ways = inside_.waysFrom(starts, blocked);
    std::vector<Seam> candidates;
    for (const std::vector<Vec3>& other : others_)
      if (const std::vector<int> chain = mirrored(other, blocked); chain.size() > 2)
        candidates.push_back({"", chain, false});
    for (const int tip : spreadTips(ways, part_.x)) {
      const std::vector<int> chain = chainTo(tip, ways);
      if (chain.size() > 2 && straightness(chain, part_.x, ways.length[tip]) > 0.85)
        candidates.push_back({"", snapped(chain, blocked), false});
    }
    return candidates;
  }

  /// The way between the vertices nearest to a mirror image; empty where the image is not on this part.
  std::vector<int> mirrored(const std::vector<Vec3>& other, const std::vector<char>& blocked) const {
    const auto image = [](Vec3 x) {
      x.x() = -x.x();
      return x;
    };
    const int mouth = nearest(image(other.front()), true), tip = nearest(image(other.back()), false);
    if (mouth < 0 || tip < 0 || blocked[tip] || taken_[mouth]) return {};
    std::vector<char> start(taken_.size(), 0);
    start[mouth] = 1;
    const Ways ways = inside_.waysFrom(start, blocked);
    return std::isfinite(ways.length[tip]) ? chainTo(tip, ways) : std::vector<int>{};
  }

  /// The chain, or the mirror image of a dart that is nearly there.
  std::vector<int> snapped(const std::vector<int>& chain, const std::vector<char>& blocked) const {
    for (const std::vector<Vec3>& other : others_) {
      const std::vector<int> image = mirrored(other, blocked);
      if (image.size() < 3) continue;
      const auto apart = [&](int v, int w) {
        return (part_.mesh.positions.row(v) - part_.mesh.positions.row(w)).norm();
      };
      if (apart(image.front(), chain.front()) < kMirrorReach && apart(image.back(), chain.back()) < kMirrorReach)
        return image;
    }
    return chain;
  }

  int nearest(const Vec3& x, bool on_outline) const {
    int best = -1;
    double least = kMirrorReach;
    for (int v = 0; v < part_.mesh.positions.rows(); ++v) {
      if (static_cast<bool>(inside_.isOutline()[v]) != on_outline) continue;
      const double distance = (part_.mesh.positions.row(v).transpose() - x).norm();
      if (distance >= least) continue;
      least = distance;
      best = v;
    }
    return best;
  }

  Part part_;
  const FlatSettings& settings_;
  const Inside inside_;
  std::vector<std::vector<Vec3>> others_;  // points of the darts so far, on this and on other pieces, m
  std::vector<char> taken_;
};

}  // namespace

std::vector<CutLine> withDarts(const RestGarment& garment, const std::vector<CutLine>& lines,
                               const FlatSettings& settings) {
  std::vector<CutLine> all = lines;
  if (settings.max_darts == 0) return all;
  std::vector<Seam> seams;
  for (const CutLine& line : lines) seams.push_back(line.seam);
  const Pieces pieces = cutIntoPieces(garment.mesh, seams);
  std::vector<std::vector<Vec3>> places;  // of the darts so far
  int count = 0;
  for (int p = 0; p < pieces.count; ++p) {
    const Part part = partOf(garment, pieces, p);
    DartSearch search(part, settings, places);
    std::vector<std::vector<Vec3>> found;
    for (Seam dart : search.run(settings.max_darts - count)) {
      std::vector<Vec3> points;
      for (int& v : dart.vertices) {
        v = part.garment_vertex[v];
        points.push_back(garment.mesh.positions.row(v));
      }
      dart.name = fmt::format("dart {}", ++count);
      all.push_back({dart, LineKind::dart});
      found.push_back(points);
    }
    places.insert(places.end(), found.begin(), found.end());
  }
  return all;
}

}  // namespace ease
