#include "garment/pattern/needless_seams.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "garment/pattern/dart_trial.h"
#include "garment/pattern/region_chains.h"
#include "garment/pattern/region_levels.h"
#include "solver/base/error.h"
#include "solver/base/parallel.h"

namespace ease {
namespace {

constexpr int kIterations = 120;       // of a trial
constexpr double kStrictness = 0.6;    // of the limit of the threads, for pieces without a seam
constexpr double kStrictShare = 0.99;  // of the area
constexpr double kMoreCloth = 1.25;    // the rectangle around a union, over those around both pieces
constexpr double kMinSaving = 0.01;    // m of seam
constexpr double kTolerance = 1e-9;    // m^2, of areas over the limits that are compared

/// A piece flattened by itself.
struct PieceTrial {
  Badness badness;
  double openings = 0.0;  // length of the lines along which it had to be opened, m
  bool is_sound = false, keeps = false;
  Vec2 box = Vec2::Zero();  // height along and width across the grain, m
};

PieceTrial tryPiece(const RestGarment& garment, const Pieces& pieces, int piece, const FlatSettings& settings) {
  PieceTrial result;
  const Part part = partOf(garment, pieces, piece);
  std::vector<Seam> openings;
  Trial trial;
  try {
    for (const CutLine& line : makeDisks(part.mesh, part.rest_edges, {}, {})) {
      openings.push_back(line.seam);
      result.openings += lengthOf(line.seam.vertices, part.mesh.positions);
    }
    trial = flattenPart(part, openings, settings, kIterations);
  } catch (const InputError&) {  // no disk, and no way to make it one
    return result;
  }
  result.badness = trial.badness;
  result.is_sound = trial.is_sound;
  result.keeps = keeps(trial.strain, settings.limits);
  result.box = (trial.x.colwise().maxCoeff() - trial.x.colwise().minCoeff()).head<2>();
  return result;
}

/// The pieces on both sides of every edge between two.
std::map<std::array<int, 2>, std::array<int, 2>> piecesBeside(const RestGarment& garment, const Pieces& pieces) {
  std::map<std::array<int, 2>, std::array<int, 2>> beside;
  for (const Edge& edge : buildTopology(garment.mesh, "the cut garment").edges)
    if (!edge.isBoundary()) beside[edge.vertex] = {pieces.piece[edge.triangle[0]], pieces.piece[edge.triangle[1]]};
  return beside;
}

class Removal {
 public:
  Removal(const RestGarment& garment, size_t kept, const FlatSettings& settings, const SewableSize& size)
      : garment_(garment),
        kept_(garment.seams.begin(), garment.seams.begin() + static_cast<long>(kept)),
        seams_(garment.seams),
        settings_(settings),
        size_(size) {
    settings_.limits.thread *= kStrictness;
    settings_.limits.share = kStrictShare;
    for (const Seam& seam : kept_) addEdges(seam, kept_edges_);
  }

  std::vector<Seam> run() {
    while (removeOne()) {
    }
    return seams_;
  }

 private:
  struct Candidate {
    size_t seam;
    std::array<int, 2> pieces;
    double length = 0.0;
    PieceTrial joined;
    std::optional<double> cost;  // energy per length saved; none: not to be removed
  };

  bool removeOne() {
    const Pieces pieces = cutIntoPieces(garment_.mesh, seams_);
    const auto beside = piecesBeside(garment_, pieces);
    std::vector<Candidate> candidates;
    for (size_t s = kept_.size(); s < seams_.size(); ++s) {
      const std::vector<int>& chain = seams_[s].vertices;
      const std::array<int, 2> at = beside.at(edgeKey(chain[0], chain[1]));
      if (at[0] == at[1]) continue;
      Candidate candidate{s, at, lengthOf(chain, garment_.mesh.positions), {}, {}};
      if (seams_[s].is_closed)
        candidate.length +=
            (garment_.mesh.positions.row(chain.front()) - garment_.mesh.positions.row(chain.back())).norm();
      candidates.push_back(candidate);
    }
    if (candidates.empty()) return false;
    std::vector<PieceTrial> alone(pieces.count);
    std::vector<char> is_small(pieces.count, 0);
    parallelFor(pieces.count, 1, [&](int p) {
      alone[p] = tryPiece(garment_, pieces, p, settings_);
      is_small[p] = isTooSmall(garment_, pieces, p, size_) ? 1 : 0;
    });
    parallelFor(static_cast<int>(candidates.size()), 1, [&](int i) { tryWithout(alone, is_small, candidates[i]); });
    const Candidate* best = nullptr;
    bool best_is_small = false;
    for (const Candidate& candidate : candidates) {
      if (!candidate.cost) continue;
      const bool small = is_small[candidate.pieces[0]] || is_small[candidate.pieces[1]];
      if (best && (best_is_small > small || (best_is_small == small && *best->cost <= *candidate.cost))) continue;
      best = &candidate;
      best_is_small = small;
    }
    if (!best) return false;
    seams_.erase(seams_.begin() + static_cast<long>(best->seam));
    chainAnew();
    return true;
  }

  /// Flattens what the pieces on both sides of a chain become without it.
  void tryWithout(const std::vector<PieceTrial>& alone, const std::vector<char>& is_small, Candidate& candidate) const {
    std::vector<Seam> without = seams_;
    without.erase(without.begin() + static_cast<long>(candidate.seam));
    const Pieces joined = cutIntoPieces(garment_.mesh, without);
    const std::array<int, 2> at =
        piecesBeside(garment_, joined)
            .at(edgeKey(seams_[candidate.seam].vertices[0], seams_[candidate.seam].vertices[1]));
    candidate.joined = tryPiece(garment_, joined, at[0], settings_);
    const PieceTrial &p = alone[candidate.pieces[0]], &q = alone[candidate.pieces[1]];
    const double saved = candidate.length + p.openings + q.openings - candidate.joined.openings;
    const bool small = is_small[candidate.pieces[0]] || is_small[candidate.pieces[1]];
    const bool no_worse = small && candidate.joined.badness.over <= p.badness.over + q.badness.over + kTolerance;
    const auto around = [](const PieceTrial& trial) { return trial.box.prod(); };
    if (candidate.joined.box.y() > size_.widest || around(candidate.joined) > kMoreCloth * (around(p) + around(q)))
      return;
    if (!candidate.joined.is_sound || !(candidate.joined.keeps || no_worse) || saved < kMinSaving) return;
    candidate.cost = (candidate.joined.badness.energy - p.badness.energy - q.badness.energy) / saved;
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
  FlatSettings settings_;
  const SewableSize size_;
  EdgeSet kept_edges_;
};

}  // namespace

std::vector<Seam> neededSeams(const RestGarment& garment, size_t kept, const FlatSettings& settings,
                              const SewableSize& size) {
  return Removal(garment, kept, settings, size).run();
}

bool isTooSmall(const RestGarment& garment, const Pieces& pieces, int piece, const SewableSize& size) {
  const Part part = partOf(garment, pieces, piece);
  const RestSurface surface = restSurface(part.mesh, part.rest_edges);
  if (surface.side * surface.side < size.area) return true;
  std::vector<double> distance(surface.vertexCount(), std::numeric_limits<double>::infinity());
  for (int v = 0; v < surface.vertexCount(); ++v)
    if (surface.on_border[v]) distance[v] = 0.0;
  marchDistances(surface, size.width, distance);
  return *std::max_element(distance.begin(), distance.end()) < 0.5 * size.width;
}

}  // namespace ease
