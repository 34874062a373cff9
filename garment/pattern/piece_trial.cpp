#include "garment/pattern/piece_trial.h"

#include <algorithm>
#include <limits>

#include "garment/pattern/region_levels.h"
#include "solver/base/error.h"

namespace ease {
namespace {

constexpr int kIterations = 120;       // of a trial
constexpr double kStrictness = 0.6;    // of the limit of the threads
constexpr double kStrictShare = 0.99;  // of the area

}  // namespace

PieceTrial tryPiece(const RestGarment& garment, const Pieces& pieces, int piece, const FlatSettings& settings) {
  PieceTrial result;
  PieceMesh part = partOf(garment, pieces, piece);
  std::vector<Seam> openings;
  Trial trial;
  try {
    for (const CutLine& line : makeDisks(part.mesh, part.rest_edges, {}, {})) {
      openings.push_back(line.seam);
      result.openings += lengthOf(line.seam.vertices, part.mesh.positions);
    }
    trial = flattenPart(part, openings, settings, kIterations);
    result.badness.energy = trial.badness.energy;
    FlatSettings softer = settings;
    softer.woven.shear = softerShear(trial.strain, settings);
    if (trial.is_sound && softer.woven.shear < settings.woven.shear) {
      part.x = trial.x;
      part.corners = trial.corners;
      const Trial sheared = flattenPart(part, openings, softer, kIterations);
      if (sheared.is_sound && (keeps(sheared.strain, settings.limits) || !keeps(trial.strain, settings.limits)))
        trial = sheared;
    }
  } catch (const InputError&) {  // no disk, and no way to make it one
    return result;
  }
  result.badness.over = trial.badness.over;
  result.is_sound = trial.is_sound;
  result.area = trial.strain.area;
  result.stretch = trial.strain.thread_mean * trial.strain.area;
  result.keeps = keeps(trial.strain, settings.limits);
  result.box = (trial.x.colwise().maxCoeff() - trial.x.colwise().minCoeff()).head<2>();
  return result;
}

FlatSettings strictLimits(FlatSettings settings) {
  settings.limits.thread *= kStrictness;
  settings.limits.share = kStrictShare;
  return settings;
}

bool isTooSmall(const RestGarment& garment, const Pieces& pieces, int piece, const SewableSize& size) {
  PieceMesh part = partOf(garment, pieces, piece);
  const RestSurface surface = restSurface(part.mesh, part.rest_edges);
  if (surface.side * surface.side < size.area) return true;
  std::vector<double> distance(surface.vertexCount(), std::numeric_limits<double>::infinity());
  for (int v = 0; v < surface.vertexCount(); ++v)
    if (surface.on_border[v]) distance[v] = 0.0;
  marchDistances(surface, size.width, distance);
  return *std::max_element(distance.begin(), distance.end()) < 0.5 * size.width;
}

}  // namespace ease
