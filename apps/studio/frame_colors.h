// Colours of the cloth by what the simulation measured.  Ranges are fixed: they depend on the scene, never on the frame.
#pragma once

#include <string>
#include <vector>

#include "apps/studio/live_run.h"
#include "viz/color_scale.h"

namespace ease {

enum class Shown { cloth, stretch, pressure, ease, growth };

/// A scale with what it stands for.
struct ShownScale {
  ColorScale scale;
  std::string label;  // with unit
  bool has_limit;
};

/// Requires another value than `cloth`.
ShownScale scaleOf(Shown shown, const Scene& scene);

/// One colour a triangle; empty: the cloth's own, or nothing was measured.
std::vector<Rgb> frameColors(Shown shown, const LiveFrame& frame);

/// What the frame tells of one triangle, in words.
std::string wordsOf(const LiveFrame& frame, int triangle);

}  // namespace ease
