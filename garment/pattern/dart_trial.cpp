#include "garment/pattern/dart_trial.h"

#include <cmath>

#include "solver/mesh/numbering.h"

namespace ease {
namespace {

constexpr double kTrialTolerance = 1e-5;  // m

Badness badnessOf(const FlatPieces& flat, const std::vector<ThreadStrain>& strains, double energy,
                  const StrainLimits& limits) {
  Badness badness{0.0, energy};
  for (size_t t = 0; t < strains.size(); ++t)
    if (strains[t].worst() > limits.thread || std::abs(strains[t].shear) > limits.shear)
      badness.over += 0.5 * flat.rest_edges[t].determinant();
  return badness;
}

}  // namespace

Trial flattenPart(const PieceMesh& part, const std::vector<Seam>& darts, const FlatSettings& settings, int iterations) {
  std::vector<CutLine> lines;
  for (const Seam& dart : darts) lines.push_back({dart, LineKind::dart});
  const CutGarment cut = cutGarment(part.mesh, lines, {});
  FlatPieces flat{
      cut.pieces.mesh.triangles, part.rest_edges, {outlineOf(cut, 0)}, static_cast<int>(cut.pieces.glue.size())};
  WovenSettings woven = settings.woven;
  woven.max_iterations = iterations;
  woven.tolerance = kTrialTolerance;
  woven.mends = false;
  const bool is_flat = part.corners.rows() > 0;
  Positions start(flat.vertices, 3);
  for (int c = 0; is_flat && c < part.corners.rows(); ++c)
    start.row(flat.triangles(c / 3, c % 3)) = part.corners.row(c);
  const Flattened flattened = flatten(flat, sewnPairs(cut), woven, is_flat ? &start : nullptr);
  const std::vector<ThreadStrain> strains = threadStrains(flat, flattened.x);
  Trial trial;
  trial.badness = badnessOf(flat, strains, flattened.energy, settings.limits);
  trial.strain = strainOf(flat, flattened.x, strains, std::vector<int>(part.rest_edges.size(), 0), 0, settings.limits);
  trial.is_sound = trial.strain.flipped == 0 && !overlapsItself(cut, 0, flattened.x);
  trial.x.resize(part.mesh.positions.rows(), 3);
  for (int v = 0; v < flat.vertices; ++v) trial.x.row(cut.pieces.glue[v]) = flattened.x.row(v);
  trial.corners.resize(flat.triangles.size(), 3);
  for (int c = 0; c < trial.corners.rows(); ++c) trial.corners.row(c) = flattened.x.row(flat.triangles(c / 3, c % 3));
  return trial;
}

PieceMesh partOf(const RestGarment& garment, const Pieces& pieces, int piece) {
  std::vector<int> triangles;
  for (size_t t = 0; t < pieces.piece.size(); ++t)
    if (pieces.piece[t] == piece) triangles.push_back(static_cast<int>(t));
  const Numbering numbering = partNumbering(pieces.mesh.triangles, std::move(triangles));
  PieceMesh part;
  part.garment_vertex = renumbered(pieces.glue, numbering.vertices);
  part.rest_edges = renumbered(garment.rest_edges, numbering.triangles);
  part.mesh = {renumbered(garment.mesh.positions, part.garment_vertex), renumbered(pieces.mesh.triangles, numbering)};
  return part;
}

}  // namespace ease
