#include "garment/pattern/variational_cut.h"

#include <fmt/format.h>

#include "garment/pattern/normal_clusters.h"
#include "solver/base/stopwatch.h"

namespace ease {
namespace {

double lengthOfSeams(const RestGarment& garment, size_t from) {
  double length = 0.0;
  for (size_t s = from; s < garment.seams.size(); ++s) {
    const std::vector<int>& chain = garment.seams[s].vertices;
    length += lengthOf(chain, garment.mesh.positions);
    if (garment.seams[s].is_closed)
      length += (garment.mesh.positions.row(chain.front()) - garment.mesh.positions.row(chain.back())).norm();
  }
  return length;
}

}  // namespace

FoundCuts findCuts(const RestGarment& given, const CutSettings& settings, const FlatSettings& flat) {
  FoundCuts found;
  const auto begin = std::chrono::steady_clock::now();
  RestGarment garment = given;
  if (!settings.keep) garment.seams.clear();
  const Pieces pieces = cutIntoPieces(garment.mesh, garment.seams);
  const RestSurface surface = restSurface(pieces.mesh, garment.rest_edges);
  const Clusters clusters = normalClusters(surface);
  const FlowResult flow = followFlow(surface, levelsFrom(surface, clusters.label, clusters.labels), settings.flow);
  found.energies = flow.energies;
  found.cut = cutAlongRegions(garment, pieces, surface, mapOf(surface, flow.levels));
  RestGarment& cut = found.cut.garment;
  const size_t kept = garment.seams.size();
  found.length_before = lengthOfSeams(cut, kept);
  found.pieces_before = cutIntoPieces(cut.mesh, cut.seams).count;
  if (settings.remove) cut.seams = neededSeams(cut, kept, flat, settings.size);
  const Pieces last = cutIntoPieces(cut.mesh, cut.seams);
  int small = 0;
  for (int p = 0; p < last.count; ++p) small += isTooSmall(cut, last, p, settings.size) ? 1 : 0;
  if (small > 0)
    found.warnings.push_back(fmt::format(
        "{} of the {} pieces that were found {} smaller than {:g} cm^2 or narrower than {:g} cm: less "
        "distortion_weight or more length_weight in [pattern.cuts] gives larger ones",
        small, last.count, small == 1 ? "is" : "are", 1e4 * settings.size.area, 100.0 * settings.size.width));
  found.wall_s = secondsSince(begin);
  return found;
}

}  // namespace ease
