#include "garment/pattern/darts.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "garment/pattern/dart_trial.h"
#include "garment/pattern/dart_ways.h"
#include "solver/base/parallel.h"

namespace ease {
namespace {

constexpr int kCandidates = 40;         // tips that are tried at a time
constexpr int kFinerCandidates = 12;    // tips that are tried around the best one
constexpr double kRefineReach = 0.035;  // m: how far from it
constexpr double kEffort = 0.15;        // m: a dart costs as much sewing as its length and this
constexpr double kMinGain = 0.07;       // share of what is still bad by which a dart must lessen it
constexpr double kStraight = 0.85;      // end to end over the length along edges, at least
constexpr double kApart = 0.04;         // m: between the mouths, and between the tips, of two darts
constexpr double kMirrorReach = 0.02;   // m
constexpr int kTrialIterations = 40;
constexpr int kIterations = 120;  // with the darts found so far
constexpr int kRefused = 4;       // best candidates that are flattened further before none is taken

/// The darts of one piece, found one after the other.
class DartSearch {
 public:
  DartSearch(const PieceMesh& part, const FlatSettings& settings, const std::vector<std::vector<Vec3>>& others,
             const std::vector<Seam>& darts)
      : part_(part),
        settings_(settings),
        edges_(part),
        others_(others),
        taken_(part.mesh.positions.rows(), 0),
        darts_(darts) {
    for (const Seam& dart : darts)
      for (const int v : dart.vertices) taken_[v] = 1;
  }

  /// Finds at most so many darts more, and returns all.
  std::vector<Seam> run(int most) {
    const size_t before = darts_.size();
    keep(flattenPart(part_, darts_, settings_, kIterations));
    while (darts_.size() < before + static_cast<size_t>(most) && !keeps(now_.strain, settings_.limits)) {
      std::vector<Attempt> attempts = attempted(candidatesNow());
      if (attempts.empty()) break;
      const std::vector<Attempt> finer = attempted(candidatesNear(attempts.front().dart.vertices.back()));
      attempts.insert(attempts.end(), finer.begin(), finer.end());
      if (!takeBest(std::move(attempts))) break;
    }
    return darts_;
  }

 private:
  /// A dart that gains enough.
  struct Attempt {
    Seam dart;
    double rate;  // gain for its length, m
  };

  double minGain() const { return kMinGain * now_.badness.all(); }

  void keep(const Trial& trial) {
    now_ = trial;
    part_.x = trial.x;
    part_.corners = trial.corners;
  }

  /// Flattens the part along each candidate; those that gain enough, the best for its length first.
  std::vector<Attempt> attempted(const std::vector<Seam>& candidates) const {
    std::vector<double> rates(candidates.size(), 0.0);
    parallelFor(static_cast<int>(candidates.size()), 1, [&](int k) {
      std::vector<Seam> with = darts_;
      with.push_back(candidates[k]);
      const Trial trial = flattenPart(part_, with, settings_, kTrialIterations);
      const double gain = now_.badness.all() - trial.badness.all();
      if (trial.is_sound && gain >= minGain())
        rates[k] = gain / (kEffort + lengthOf(candidates[k].vertices, part_.mesh.positions));
    });
    std::vector<Attempt> attempts;
    for (size_t k = 0; k < candidates.size(); ++k)
      if (rates[k] > 0.0) attempts.push_back({candidates[k], rates[k]});
    sortByRate(attempts);
    return attempts;
  }

  static void sortByRate(std::vector<Attempt>& attempts) {
    std::stable_sort(attempts.begin(), attempts.end(),
                     [](const Attempt& a, const Attempt& b) { return a.rate > b.rate; });
  }

  /// Adds the best of them that still gains enough when it is flattened further; returns false where none does.
  bool takeBest(std::vector<Attempt> attempts) {
    sortByRate(attempts);
    for (size_t k = 0; k < std::min<size_t>(attempts.size(), kRefused); ++k) {
      darts_.push_back(attempts[k].dart);
      const Trial next = flattenPart(part_, darts_, settings_, kIterations);
      if (next.is_sound && now_.badness.all() - next.badness.all() >= minGain()) {
        for (const int v : darts_.back().vertices) taken_[v] = 1;
        others_.push_back(positionsOf(darts_.back().vertices, part_.mesh.positions));
        keep(next);
        return true;
      }
      darts_.pop_back();
    }
    return false;
  }

  /// Shortest darts to tips spread over the part, and the mirror images of darts on the wearer's other side, which
  /// come first so that they win where they gain as much.
  std::vector<Seam> candidatesNow() const {
    std::vector<Seam> candidates;
    for (const std::vector<Vec3>& other : others_)
      if (const std::vector<int> chain = mirrored(other); chain.size() > 2 && isApart(chain))
        candidates.push_back({"", straightened(chain), false});
    const Ways ways = waysInside();
    addDarts(ways, spreadTips(ways, part_.x, kCandidates), candidates);
    return candidates;
  }

  /// Darts to tips around that one.
  std::vector<Seam> candidatesNear(int tip) const {
    Ways ways = waysInside();
    for (int v = 0; v < part_.x.rows(); ++v)
      if ((part_.x.row(v) - part_.x.row(tip)).norm() > kRefineReach)
        ways.length[v] = std::numeric_limits<double>::infinity();
    std::vector<Seam> candidates;
    addDarts(ways, spreadTips(ways, part_.x, kFinerCandidates), candidates);
    return candidates;
  }

  void addDarts(const Ways& ways, const std::vector<int>& tips, std::vector<Seam>& candidates) const {
    for (const int tip : tips) {
      const std::vector<int> chain = ways.to(tip);
      if (chain.size() > 2 && isStraight(chain, ways.length[tip]) && isApart(chain))
        candidates.push_back({"", straightened(snapped(chain)), false});
    }
  }

  bool isStraight(const std::vector<int>& chain, double length) const {
    return (part_.x.row(chain.back()) - part_.x.row(chain.front())).norm() > kStraight * length;
  }

  /// Whether it begins and ends away from the darts so far: two beside each other are one that is badly placed.
  bool isApart(const std::vector<int>& chain) const {
    return std::all_of(darts_.begin(), darts_.end(), [&](const Seam& dart) {
      return apart(dart.vertices.front(), chain.front()) > kApart && apart(dart.vertices.back(), chain.back()) > kApart;
    });
  }

  double apart(int v, int w) const { return (part_.mesh.positions.row(v) - part_.mesh.positions.row(w)).norm(); }

  /// The dart led nearer to the straight line that it is drawn as.
  std::vector<int> straightened(const std::vector<int>& chain) const {
    const std::vector<int> way = edges_.straightWay(chain.front(), chain.back(), part_.x, blocked());
    return way.size() > 2 ? way : chain;
  }

  Ways waysInside() const {
    std::vector<char> starts = edges_.isOutline();
    for (size_t v = 0; v < starts.size(); ++v)
      if (taken_[v]) starts[v] = 0;
    return edges_.waysFrom(starts, blocked());
  }

  /// By vertex, whether a dart may not pass through it: on the outline or on another dart.
  std::vector<char> blocked() const {
    std::vector<char> blocked = edges_.isOutline();
    for (size_t v = 0; v < blocked.size(); ++v)
      if (taken_[v]) blocked[v] = 1;
    return blocked;
  }

  /// The way between the vertices nearest to a mirror image; empty where the image is not on this part.
  std::vector<int> mirrored(const std::vector<Vec3>& other) const {
    const auto image = [](Vec3 x) {
      x.x() = -x.x();
      return x;
    };
    const int mouth = nearest(image(other.front()), true), tip = nearest(image(other.back()), false);
    const std::vector<char> closed = blocked();
    if (mouth < 0 || tip < 0 || closed[tip] || taken_[mouth]) return {};
    std::vector<char> start(taken_.size(), 0);
    start[mouth] = 1;
    const Ways ways = edges_.waysFrom(start, closed);
    return std::isfinite(ways.length[tip]) ? ways.to(tip) : std::vector<int>{};
  }

  /// The chain, or the mirror image of a dart that is nearly there.
  std::vector<int> snapped(const std::vector<int>& chain) const {
    for (const std::vector<Vec3>& other : others_) {
      const std::vector<int> image = mirrored(other);
      if (image.size() < 3) continue;
      if (apart(image.front(), chain.front()) < kMirrorReach && apart(image.back(), chain.back()) < kMirrorReach)
        return image;
    }
    return chain;
  }

  int nearest(const Vec3& x, bool on_outline) const {
    int best = -1;
    double least = kMirrorReach;
    for (int v = 0; v < part_.mesh.positions.rows(); ++v) {
      if (static_cast<bool>(edges_.isOutline()[v]) != on_outline) continue;
      const double distance = (part_.mesh.positions.row(v).transpose() - x).norm();
      if (distance >= least) continue;
      least = distance;
      best = v;
    }
    return best;
  }

  PieceMesh part_;
  const FlatSettings& settings_;
  const PartEdges edges_;
  std::vector<std::vector<Vec3>> others_;  // points of the darts so far, on this and on other pieces, m
  std::vector<char> taken_;
  std::vector<Seam> darts_;
  Trial now_;  // with these darts
};

/// The darts that lie on a part, by its own vertices.
std::vector<Seam> within(const PieceMesh& part, const std::vector<Seam>& darts) {
  std::map<int, int> number;
  for (size_t v = 0; v < part.garment_vertex.size(); ++v) number.emplace(part.garment_vertex[v], static_cast<int>(v));
  std::vector<Seam> own;
  for (Seam dart : darts) {
    if (!number.contains(dart.vertices.back())) continue;  // its tip; its mouth may lie on a seam between two parts
    for (int& v : dart.vertices) v = number.at(v);
    own.push_back(dart);
  }
  return own;
}

}  // namespace

std::vector<CutLine> withDarts(const RestGarment& garment, const std::vector<CutLine>& lines,
                               const FlatSettings& settings) {
  std::vector<CutLine> all = lines;
  if (settings.max_darts == 0) return all;
  std::vector<Seam> seams, given;
  std::vector<std::vector<Vec3>> places;  // of the darts so far
  for (const CutLine& line : lines) {
    (line.kind == LineKind::dart ? given : seams).push_back(line.seam);
    if (line.kind == LineKind::dart) places.push_back(positionsOf(line.seam.vertices, garment.mesh.positions));
  }
  const Pieces pieces = cutIntoPieces(garment.mesh, seams);
  int count = static_cast<int>(given.size());
  for (int p = 0; p < pieces.count; ++p) {
    const PieceMesh part = partOf(garment, pieces, p);
    const std::vector<Seam> own = within(part, given);
    std::vector<Seam> darts = DartSearch(part, settings, places, own).run(settings.max_darts - count);
    for (size_t d = own.size(); d < darts.size(); ++d) {
      for (int& v : darts[d].vertices) v = part.garment_vertex[v];
      darts[d].name = fmt::format("dart {}", ++count);
      all.push_back({darts[d], LineKind::dart});
      places.push_back(positionsOf(darts[d].vertices, garment.mesh.positions));
    }
  }
  return all;
}

}  // namespace ease
