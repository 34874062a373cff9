// Pictures of a garment on a body, rendered without a display.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/mesh/triangle_mesh.h"
#include "viz/color_scale.h"

namespace ease {

/// A line on the garment, e.g. one of its loops.
struct ViewLine {
  std::vector<Vec3> points;  // m
  bool is_closed;
  Rgb color;
};

/// One view: a garment coloured by a value per triangle, on a body drawn plainly.
struct StretchView {
  std::string title;  // "before", "after"
  const TriangleMesh* garment;
  std::vector<float> values;  // per triangle, e.g. sigma_1
  const TriangleMesh* body;   // may be null
  std::string summary = {};   // below the title; empty: the largest value, and how many are over the limit
  std::vector<ViewLine> lines = {};
};

/// Draws the views side by side (each from the front and, smaller or beside, from the back) with one colour scale from
/// `low` to `high`, marked with `limit` and labelled, as a PNG.  Returns an empty string, or why no picture could be
/// made (never throws, never ends the program: a machine may have no way to render).
std::string drawStretch(const std::filesystem::path& file, const std::vector<StretchView>& views,
                        const std::string& label, double low, double high, double limit);

}  // namespace ease
