// Colours of the cloth by what the simulation measured.  Ranges are fixed: they depend on the scene, never on the
// frame.
#pragma once

#include <string>
#include <vector>

#include "apps/studio/live_run.h"
#include "viz/color_scale.h"

namespace ease {

/// `pieces`: which piece of the sewing pattern a triangle belongs to, as the seams cut.
enum class Shown { cloth, stretch, pressure, ease, growth, pieces };

/// A scale with what it stands for.
struct ShownScale {
  ColorScale scale;
  std::string label;  // with unit
  bool has_limit;
};

/// Whether it is a quantity, which has a scale.
inline bool hasScale(Shown shown) {
  return shown != Shown::cloth && shown != Shown::pieces;
}

/// Requires a quantity.
ShownScale scaleOf(Shown shown, const Scene& scene);

/// One colour a triangle; empty: the cloth's own, or nothing was measured.
std::vector<Rgb> frameColors(Shown shown, const LiveFrame& frame);

/// What the frame tells of one triangle, in words.
std::string wordsOf(const LiveFrame& frame, int triangle);

}  // namespace ease
