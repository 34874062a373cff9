#include "apps/pattern_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "apps/flat_settings.h"
#include "apps/page/garment_areas.h"
#include "apps/painted_rest.h"
#include "apps/words.h"
#include "garment/pattern/piece_warnings.h"

namespace ease {

namespace {

/// Throws where a plane of symmetry is given that misses the garment.
void checkPlane(const Scene& scene, const SceneInput& input) {
  const std::optional<double> plane = scene.pattern.cuts->settings.plane;
  const auto x = input.garment.positions.col(0);
  if (!plane || (*plane > x.minCoeff() && *plane < x.maxCoeff())) return;
  throw InputError(fmt::format(
      "{}: [pattern.cuts] symmetric = {:g}: the plane misses the garment: expected {:.3f} to {:.3f} m, or true",
      scene.file.string(), *plane, x.minCoeff(), x.maxCoeff()));
}

/// Throws InputError where a piece of this width, m, does not fit onto the cloth even if it is taken in.
void checkWidths(const Scene& scene, const FlatPattern& pattern, double widest) {
  constexpr double kTakenIn = 0.95;  // of a piece's width, at least, that the rest shape's has
  const std::vector<double> widths = widthsAcross(pattern);
  for (size_t p = 0; p < widths.size(); ++p)
    if (const double width = widths[p]; kTakenIn * width > widest)
      throw InputError(fmt::format(
          "fabric_width = {:g}: piece '{}' is about {:.2f} m wide across the grain, and {:.2f} m with its allowance: "
          "expected wider fabric, or a seam that divides the piece",
          scene.pattern.fabric_width, pattern.pieces[p].name, width, width + scene.pattern.fabric_width - widest));
}

}  // namespace

bool findsCuts(const Scene& scene, const SceneInput& input) {
  const bool finds = scene.pattern.cuts ? scene.pattern.cuts->finds : input.seams.empty();
  if (input.seams.empty() && !finds)
    throw InputError(
        fmt::format("{}: [garment] has no [[garment.seam]] and [pattern.cuts] method = 'none': expected seams, along "
                    "which a pattern is cut, or method = 'variational'",
                    scene.file.string()));
  if (finds && scene.pattern.cuts) checkPlane(scene, input);
  return finds;
}

void checkAllowanceNames(const Allowances& allowances, const CutGarment& cut) {
  std::set<std::string> known;
  for (const PieceEdge& edge : cut.edges)
    if (edge.kind != LineKind::dart) known.insert(edge.name);
  for (const auto& [name, width] : allowances.by_name)
    if (!known.contains(name))
      throw InputError(fmt::format("allowance.{}: no piece has such a seam or edge; {}", name,
                                   adviceFor(name, {known.begin(), known.end()}, "there are")));
}

void checkPieces(const Scene& scene, const SceneInput& input) {
  FlatSettings settings = flatSettings(scene);
  settings.max_darts = 0;
  Cloth cloth(input.garment, scene.garment.grain, scene.material);
  if (!input.paint.empty()) paintFirstRest(input.paint, cloth);
  ofPattern(scene, [&] {
    const FlatPattern pattern = flattenGarment(
        {{cloth.restPositions(), input.garment.triangles}, cloth.restEdges(), input.seams, loopsOf(input)}, settings);
    checkAllowanceNames(scene.pattern.allowances, pattern.cut);
    checkWidths(scene, pattern, settings.widest);
  });
}

}  // namespace ease
