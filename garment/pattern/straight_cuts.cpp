#include "garment/pattern/straight_cuts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "garment/pattern/region_chains.h"
#include "solver/base/parallel.h"

namespace ease {
namespace {

constexpr double kMoreLength = 1.15;  // weight of the length, from one round to the next
constexpr int kFailures = 2;          // rounds beyond what is allowed, each then tried with half of the step
constexpr int kRounds = 8;
constexpr int kSteps = 20;               // of the flow in a round
constexpr double kFlowTolerance = 1e-3;  // of the flow in a round
constexpr double kTolerance = 1e-9;      // m^2
constexpr double kShorter = 0.998;       // of the length of the seams, for a round to count
constexpr double kMeanShare = 0.2;       // of the limit of the threads, that they stretch by in the mean

/// How well the pieces of a cut garment lie flat.
struct Fitness {
  int count = 0, small = 0;
  double over = 0.0;     // area over the limits beyond the share that may be, m^2
  double stretch = 0.0;  // mean of the threads
  bool is_sound = true;
};

Fitness fitnessOf(const RestGarment& garment, const FlatSettings& flat, const SewableSize& size) {
  Fitness fitness;
  const Pieces pieces = cutIntoPieces(garment.mesh, garment.seams);
  fitness.count = pieces.count;
  const FlatSettings strict = strictLimits(flat);
  std::vector<PieceTrial> trials(pieces.count);
  std::vector<char> is_small(pieces.count, 0);
  parallelFor(pieces.count, 1, [&](int p) {
    trials[p] = tryPiece(garment, pieces, p, strict);
    is_small[p] = isTooSmall(garment, pieces, p, size) ? 1 : 0;
  });
  double area = 0.0;
  for (const PieceTrial& trial : trials) {
    area += trial.area;
    fitness.stretch += trial.stretch;
    fitness.over += std::max(0.0, trial.badness.over - (1.0 - strict.limits.share) * trial.area);
    fitness.is_sound = fitness.is_sound && trial.is_sound && trial.box.y() <= size.widest;
  }
  fitness.stretch /= area;
  fitness.small = static_cast<int>(std::count(is_small.begin(), is_small.end(), 1));
  return fitness;
}

/// Whether a garment may be cut so, too, where it was cut so at first.
bool isFit(const Fitness& next, const Fitness& first, double thread_limit) {
  return next.is_sound && next.count == first.count && next.small <= first.small &&
         next.over <= first.over + kTolerance && next.stretch <= std::max(first.stretch, kMeanShare * thread_limit);
}

}  // namespace

RegionLevels levelsOfPieces(const CutPlace& place, const RegionLevels& levels, const CutUp& cut) {
  RegionMap map = mapOf(place.surface, levels);
  const Regions regions = connectedRegions(place.surface, map);
  const Pieces pieces = cutIntoPieces(cut.garment.mesh, cut.garment.seams);
  std::vector<std::map<int, double>> votes(regions.area.size());  // by region: area by piece
  for (size_t t = 0; t < cut.source.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int v = place.surface.mesh.triangles(cut.source[t], k);
      const std::array<int, 3> labels = labelsOf(place.surface, map, cut.source[t]);
      const bool is_whole = labels[0] == labels[1] && labels[1] == labels[2];
      votes[regions.of[v]][pieces.piece[t]] += (is_whole ? 1.0 : 1e-3) * cut.garment.rest_edges[t].determinant();
    }
  std::vector<int> piece_of(regions.area.size(), 0);
  for (size_t r = 0; r < votes.size(); ++r)
    piece_of[r] = std::max_element(votes[r].begin(), votes[r].end(), [](const auto& a, const auto& b) {
                    return a.second < b.second;
                  })->first;
  for (size_t v = 0; v < map.label.size(); ++v) map.label[v] = piece_of[regions.of[v]];
  return redistanced(place.surface, map, pieces.count);
}

LevelCut straightest(const CutPlace& place, LevelCut given, const FlowSettings& flow, const FlatSettings& flat,
                     const SewableSize& size, const MirrorLevels* mirror) {
  const Fitness first = fitnessOf(given.cut.garment, flat, size);
  double length = lengthOfSeams(given.cut.garment.seams, given.cut.garment.mesh.positions);
  FlowSettings settings = flow;
  settings.steps = std::min(flow.steps, kSteps);
  settings.tolerance = std::max(flow.tolerance, kFlowTolerance);
  settings.joins = false;
  RegionLevels levels = levelsOfPieces(place, given.levels, given.cut);
  if (mirror) (*mirror)(levels);
  double more = kMoreLength;
  for (int round = 0, failures = 0; round < kRounds && first.is_sound && failures < kFailures; ++round) {
    FlowSettings next = settings;
    next.weights.length *= more;
    const RegionLevels straighter = followFlow(place.surface, levels, next, mirror).levels;
    CutUp cut = cutAlongRegions(place.garment, place.pieces, place.surface, mapOf(place.surface, straighter));
    const double now = lengthOfSeams(cut.garment.seams, cut.garment.mesh.positions);
    const bool is_shorter = now < kShorter * length;
    if (is_shorter && !isFit(fitnessOf(cut.garment, flat, size), first, flat.limits.thread)) {
      more = std::sqrt(more);  // and from the same lines again
      ++failures;
      continue;
    }
    settings = next;
    levels = straighter;
    if (!is_shorter) continue;
    length = now;
    given = {levels, std::move(cut), settings.weights.length};
  }
  return given;
}

}  // namespace ease
