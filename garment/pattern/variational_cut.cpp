#include "garment/pattern/variational_cut.h"

#include <fmt/format.h>

#include "garment/pattern/mirror_levels.h"
#include "garment/pattern/normal_clusters.h"
#include "garment/pattern/region_chains.h"
#include "garment/pattern/seam_names.h"
#include "solver/base/error.h"
#include "solver/base/stopwatch.h"

namespace ease {
namespace {

constexpr double kReach = 2.0;  // mean edge lengths: how far the image of a vertex may be from the surface

}  // namespace

FoundCuts findCuts(const RestGarment& given, const CutSettings& settings, const FlatSettings& flat) {
  FoundCuts found;
  const auto begin = std::chrono::steady_clock::now();
  RestGarment garment = given;
  if (!settings.keep) garment.seams.clear();
  const Pieces pieces = cutIntoPieces(garment.mesh, garment.seams);
  const RestSurface surface = restSurface(pieces.mesh, garment.rest_edges);
  const Clusters clusters = normalClusters(surface);
  RegionLevels start = levelsFrom(surface, clusters.label, clusters.labels);
  std::optional<MirrorLevels> symmetry;
  const double plane = settings.plane.value_or(middlePlane(surface));
  if (settings.is_symmetric) {
    const double low = garment.mesh.positions.col(0).minCoeff(), high = garment.mesh.positions.col(0).maxCoeff();
    if (plane <= low || plane >= high)
      throw InputError(fmt::format("cuts.symmetric = {:g}: the plane misses the garment: expected {:.3f} to {:.3f} m",
                                   plane, low, high));
    symmetry.emplace(surface, plane, kReach * surface.mean_edge);
    (*symmetry)(start);
  }
  const MirrorLevels* const mirror = symmetry ? &*symmetry : nullptr;
  const FlowResult flow = followFlow(surface, start, settings.flow, mirror);
  found.energies = flow.energies;
  found.cut = cutAlongRegions(garment, pieces, surface, mapOf(surface, flow.levels));
  RestGarment& cut = found.cut.garment;
  const size_t kept = garment.seams.size();
  found.length_before = lengthOfSeams(cut.seams, cut.mesh.positions);
  found.pieces_before = cutIntoPieces(cut.mesh, cut.seams).count;
  const std::optional<double> halves = settings.is_symmetric ? std::optional<double>(plane) : std::nullopt;
  if (settings.remove) cut.seams = neededSeams(cut, kept, flat, settings.size, halves);
  found.length_weight = settings.flow.weights.length;
  if (settings.straighten) {
    LevelCut straight = straightest({garment, pieces, surface}, {flow.levels, found.cut, found.length_weight},
                                    settings.flow, flat, settings.size, mirror);
    found.cut = std::move(straight.cut);
    found.length_weight = straight.length_weight;
  }
  const Pieces last = cutIntoPieces(cut.mesh, cut.seams);
  int small = 0;
  for (int p = 0; p < last.count; ++p) small += isTooSmall(cut, last, p, settings.size) ? 1 : 0;
  if (small > 0)
    found.warnings.push_back(fmt::format(
        "{} of the {} pieces that were found {} smaller than {:g} cm^2 or narrower than {:g} cm: less "
        "distortion_weight or more length_weight in [pattern.cuts] gives larger ones",
        small, last.count, small == 1 ? "is" : "are", 1e4 * settings.size.area, 100.0 * settings.size.width));
  nameFoundSeams(kept, flat.names, cut);
  found.length = lengthOfSeams(cut.seams, cut.mesh.positions);
  found.wall_s = secondsSince(begin);
  return found;
}

}  // namespace ease
