// Picture of pattern pieces in the plane: triangles coloured by a value, lines over them, names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viz/picture.h"

namespace ease {

struct FlatLabel {
  Vec3 at;  // as the positions
  std::string words;
  int size = 16;  // pixels
};

/// What is drawn; z is left out.
struct FlatView {
  TriangleMesh pieces;
  std::vector<float> values;  // one per triangle
  std::vector<ViewLine> lines;
  std::vector<FlatLabel> labels;
  std::string title, summary;
};

/// Draws a PNG file with a colour scale from `low` to `high` that shows `limit` and `label`.  Returns an empty string,
/// or the reason why no picture could be made.
std::string drawFlat(const std::filesystem::path& file, const FlatView& view, const std::string& label, double low,
                     double high, double limit);

}  // namespace ease
