#include "garment/pattern/needless_seams.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "garment/pattern/region_chains.h"
#include "solver/base/parallel.h"

namespace ease {
namespace {

constexpr double kMoreCloth = 1.25;    // the rectangle around a union, over those around both pieces
constexpr double kMirrorReach = 0.03;  // m: how far the middles of a seam and of another's image may be apart
constexpr double kMinSaving = 0.01;    // m of seam
constexpr double kTolerance = 1e-9;    // m^2, of areas over the limits that are compared

/// The pieces on both sides of every edge between two.
std::map<std::array<int, 2>, std::array<int, 2>> piecesBeside(const RestGarment& garment, const Pieces& pieces) {
  std::map<std::array<int, 2>, std::array<int, 2>> beside;
  for (const Edge& edge : buildTopology(garment.mesh, "the cut garment").edges)
    if (!edge.isBoundary()) beside[edge.vertex] = {pieces.piece[edge.triangle[0]], pieces.piece[edge.triangle[1]]};
  return beside;
}

class Removal {
 public:
  Removal(const RestGarment& garment, size_t kept, const FlatSettings& settings, const SewableSize& size,
          std::optional<double> mirror)
      : garment_(garment),
        kept_(garment.seams.begin(), garment.seams.begin() + static_cast<long>(kept)),
        seams_(garment.seams),
        given_(settings),
        settings_(strictLimits(settings)),
        size_(size),
        mirror_(mirror) {
    for (const Seam& seam : kept_) addEdges(seam, kept_edges_);
  }

  std::vector<Seam> run() {
    while (removeOne()) {
    }
    return seams_;
  }

 private:
  /// Seams that would go together.
  struct Candidate {
    std::vector<size_t> seams;
    std::set<int> pieces;  // beside them
    double length = 0.0;
    std::optional<double> cost;  // energy per length saved; none: not to be removed
  };

  bool removeOne() {
    const Pieces pieces = cutIntoPieces(garment_.mesh, seams_);
    std::vector<Candidate> candidates = candidatesNow(piecesBeside(garment_, pieces));
    if (candidates.empty()) return false;
    std::vector<PieceTrial> alone(pieces.count);
    std::vector<char> is_small(pieces.count, 0);
    parallelFor(pieces.count, 1, [&](int p) {
      alone[p] = tryPiece(garment_, pieces, p, settings_);
      is_small[p] = isTooSmall(garment_, pieces, p, size_) ? 1 : 0;
    });
    const auto mends = [&](const Candidate& candidate) {
      return std::any_of(candidate.pieces.begin(), candidate.pieces.end(), [&](int p) { return is_small[p] != 0; });
    };
    parallelFor(static_cast<int>(candidates.size()), 1,
                [&](int i) { tryWithout(alone, mends(candidates[i]), candidates[i]); });
    const Candidate* best = nullptr;
    for (const Candidate& candidate : candidates) {
      if (!candidate.cost) continue;
      const auto rank = [&](const Candidate& c) { return std::pair(!mends(c), *c.cost); };
      if (!best || rank(candidate) < rank(*best)) best = &candidate;
    }
    if (!best) return false;
    seams_ = without(*best);
    chainAnew();
    return true;
  }

  std::vector<Candidate> candidatesNow(const std::map<std::array<int, 2>, std::array<int, 2>>& beside) const {
    std::vector<Candidate> candidates;
    for (size_t s = kept_.size(); s < seams_.size(); ++s) {
      Candidate candidate{{s}, {}, 0.0, {}};
      if (mirror_ && std::abs(middleOf(s).x() - *mirror_) > kMirrorReach) {
        const std::optional<size_t> image = imageOf(s);
        if (!image || imageOf(*image) != s || *image < s) continue;  // without its image it stays; or tried already
        candidate.seams.push_back(*image);
      }
      bool is_between = true;
      for (const size_t seam : candidate.seams) {
        const std::array<int, 2> at = beside.at(firstEdge(seam));
        is_between = is_between && at[0] != at[1];
        candidate.pieces.insert(at.begin(), at.end());
        candidate.length += lengthOfSeam(seams_[seam], garment_.mesh.positions);
      }
      if (is_between) candidates.push_back(std::move(candidate));
    }
    return candidates;
  }

  std::array<int, 2> firstEdge(size_t seam) const {
    return edgeKey(seams_[seam].vertices[0], seams_[seam].vertices[1]);
  }

  Vec3 middleOf(size_t seam) const {
    Vec3 middle = Vec3::Zero();
    for (const int v : seams_[seam].vertices) middle += garment_.mesh.positions.row(v);
    return middle / static_cast<double>(seams_[seam].vertices.size());
  }

  /// The seam whose middle is nearest to the mirror image of another's; none within a few centimetres.
  std::optional<size_t> imageOf(size_t seam) const {
    Vec3 image = middleOf(seam);
    image.x() = 2.0 * *mirror_ - image.x();
    std::optional<size_t> nearest;
    double least = kMirrorReach;
    for (size_t s = kept_.size(); s < seams_.size(); ++s)
      if (const double distance = (middleOf(s) - image).norm(); distance < least) {
        least = distance;
        nearest = s;
      }
    return nearest;
  }

  std::vector<Seam> without(const Candidate& candidate) const {
    std::vector<Seam> seams;
    for (size_t s = 0; s < seams_.size(); ++s)
      if (std::find(candidate.seams.begin(), candidate.seams.end(), s) == candidate.seams.end())
        seams.push_back(seams_[s]);
    return seams;
  }

  /// Flattens what the pieces beside a candidate become without it.  `mends`: one of them is too small.
  void tryWithout(const std::vector<PieceTrial>& alone, bool mends, Candidate& candidate) const {
    const Pieces joined = cutIntoPieces(garment_.mesh, without(candidate));
    const auto beside = piecesBeside(garment_, joined);
    std::set<int> unions;
    for (const size_t seam : candidate.seams) unions.insert(beside.at(firstEdge(seam))[0]);
    double saved = candidate.length, energy = 0.0, over = kTolerance, box = 0.0;  // of unions less those of pieces
    for (const int p : candidate.pieces) {
      saved += alone[p].openings;
      energy -= alone[p].badness.energy;
      over += alone[p].badness.over;
      box += alone[p].box.prod();
    }
    bool keeps_limits = true, keeps_given = mends;
    for (const int p : unions) {
      const PieceTrial trial = tryPiece(garment_, joined, p, settings_);
      if (!trial.is_sound || trial.box.y() > size_.widest) return;
      saved -= trial.openings;
      energy += trial.badness.energy;
      over -= trial.badness.over;
      box -= trial.box.prod() / kMoreCloth;
      keeps_limits = keeps_limits && trial.keeps;
      keeps_given = keeps_given && (trial.keeps || tryPiece(garment_, joined, p, given_).keeps);
    }
    if (saved < kMinSaving || box < 0.0 || !(keeps_limits || keeps_given || (mends && over >= 0.0))) return;
    candidate.cost = energy / saved;
  }

  /// Chains that met the removed one become one.
  void chainAnew() {
    EdgeSet edges;
    for (size_t s = kept_.size(); s < seams_.size(); ++s) addEdges(seams_[s], edges);
    seams_ = kept_;
    for (Seam& seam : chainsAlong(garment_.mesh, edges, kept_edges_)) seams_.push_back(std::move(seam));
  }

  const RestGarment& garment_;
  const std::vector<Seam> kept_;
  std::vector<Seam> seams_;
  const FlatSettings given_, settings_;  // as of the pattern, and stricter
  const SewableSize size_;
  const std::optional<double> mirror_;
  EdgeSet kept_edges_;
};

}  // namespace

std::vector<Seam> neededSeams(const RestGarment& garment, size_t kept, const FlatSettings& settings,
                              const SewableSize& size, std::optional<double> mirror) {
  return Removal(garment, kept, settings, size, mirror).run();
}

}  // namespace ease
