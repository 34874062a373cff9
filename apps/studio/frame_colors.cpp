#include "apps/studio/frame_colors.h"

#include <fmt/format.h>

#include <cmath>

#include "apps/run_pictures.h"
#include "garment/pieces.h"

namespace ease {

namespace {

constexpr double kMaxPressure = 2000.0;  // Pa: about what a tight waistband presses with
constexpr double kMaxEase = 50.0;        // mm
constexpr double kMaxShownGrowth = 1.5;  // area over area

/// Mean of the triangle's corners.
double meanAt(const std::vector<double>& values, const Triangles& triangles, int t) {
  return (values[triangles(t, 0)] + values[triangles(t, 1)] + values[triangles(t, 2)]) / 3.0;
}

/// Colours of the pieces into which the seams cut the garment; the colour-blind can tell neighbours apart.
std::vector<Rgb> pieceColors(const LiveFrame& frame) {
  static const Rgb kPieces[] = {{86, 180, 233}, {230, 159, 0},   {0, 158, 115},
                                {240, 228, 66}, {204, 121, 167}, {0, 114, 178}};
  std::vector<Rgb> colors;
  if (!frame.made->input.authored) return colors;
  for (const int piece : cutIntoPieces(frame.made->input.garment, frame.made->input.authored->seams).piece)
    colors.push_back(kPieces[piece % std::size(kPieces)]);
  return colors;
}

}  // namespace

ShownScale scaleOf(Shown shown, const Scene& scene) {
  switch (shown) {
    case Shown::pressure:
      return {ColorScale(0.0, kMaxPressure, kMaxPressure), "pressure of the body, Pa", false};
    case Shown::ease:
      return {ColorScale(0.0, kMaxEase, kMaxEase), "ease: room beyond the comfort offset, mm", false};
    case Shown::growth:
      return {ColorScale(1.0, kMaxShownGrowth, kMaxShownGrowth), "area of the rest shape over its first", false};
    default:
      break;
  }
  const double limit = shownLimit(scene);
  return {ColorScale(1.0, 1.0 + 2.0 * limit, 1.0 + limit), "stretch (largest principal)", true};
}

std::vector<Rgb> frameColors(Shown shown, const LiveFrame& frame) {
  std::vector<Rgb> colors;
  if (shown == Shown::pieces) return pieceColors(frame);
  if (shown == Shown::cloth) return colors;
  const ColorScale scale = scaleOf(shown, frame.made->scene).scale;
  const Triangles& triangles = frame.made->input.garment.triangles;
  const auto count = static_cast<int>(triangles.rows());
  const std::vector<double>& values = shown == Shown::pressure ? frame.pressure : frame.gap;
  if ((shown == Shown::pressure || shown == Shown::ease) && values.empty()) return colors;
  // The conversion from Oklab costs more than the lookup in a table of its results.
  constexpr int kEntries = 512;
  std::vector<Rgb> table;
  for (int i = 0; i < kEntries; ++i)
    table.push_back(scale.color(scale.low() + (scale.high() - scale.low()) * (i + 0.5) / kEntries));
  colors.reserve(count);
  for (int t = 0; t < count; ++t) {
    double value = 0.0;
    if (shown == Shown::stretch) value = frame.stretch[t].sigma_1;
    if (shown == Shown::growth) value = frame.growth[t];
    if (shown == Shown::pressure) value = meanAt(values, triangles, t);
    if (shown == Shown::ease) value = 1000.0 * meanAt(values, triangles, t);
    const double entry = (value - scale.low()) / (scale.high() - scale.low()) * kEntries;
    colors.push_back(std::isfinite(entry) ? table[static_cast<int>(std::clamp(entry, 0.0, kEntries - 1.0))]
                                          : scale.color(std::nan("")));
  }
  return colors;
}

std::string wordsOf(const LiveFrame& frame, int t) {
  std::string words = fmt::format("Under the pointer: stretch {:.3f} and {:.3f}, area {:.2f} of the first",
                                  frame.stretch[t].sigma_1, frame.stretch[t].sigma_2, frame.growth[t]);
  const Triangles& triangles = frame.made->input.garment.triangles;
  if (!frame.gap.empty()) words += fmt::format(", ease {:.0f} mm", 1000.0 * meanAt(frame.gap, triangles, t));
  if (!frame.pressure.empty()) words += fmt::format(", pressure {:.0f} Pa", meanAt(frame.pressure, triangles, t));
  return words;
}

}  // namespace ease
