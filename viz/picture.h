// Pictures of a garment on a body, rendered without a display.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/mesh/triangle_mesh.h"
#include "viz/color_scale.h"

namespace ease {

/// A line drawn on the garment, for example one of its boundary loops.
struct ViewLine {
  std::vector<Vec3> points;  // m
  bool is_closed;
  Rgb color;
};

/// One view of a picture: a garment coloured by a value per triangle, on a body of a single colour.
struct StretchView {
  std::string title;  // "before", "after"
  const TriangleMesh* garment;
  std::vector<float> values;  // per triangle, e.g. sigma_1
  const TriangleMesh* body;   // may be null
  std::string summary = {};   // text below the title; if empty, the largest value and the count over the limit
  std::vector<ViewLine> lines = {};
};

/// Draws the views side by side, each from the front and from the back, and writes them as a PNG file.  All views share
/// one colour scale from `low` to `high`, which shows `limit` and `label`.  Returns an empty string, or the reason why
/// no picture could be made.  Does not throw, because a run should not fail on a machine that cannot render.
std::string drawStretch(const std::filesystem::path& file, const std::vector<StretchView>& views,
                        const std::string& label, double low, double high, double limit);

}  // namespace ease
