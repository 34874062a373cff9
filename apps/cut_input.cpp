#include "apps/cut_input.h"

#include <algorithm>

namespace ease {
namespace {

Positions interpolated(const CutUp& cut, const Positions& uncut) {
  Positions x(static_cast<int>(cut.vertices.size()), 3);
  for (size_t v = 0; v < cut.vertices.size(); ++v) {
    const CutVertex& at = cut.vertices[v];
    x.row(static_cast<int>(v)) =
        at.share[0] * uncut.row(at.from[0]) + at.share[1] * uncut.row(at.from[1]) + at.share[2] * uncut.row(at.from[2]);
  }
  return x;
}

}  // namespace

void cutInput(const CutUp& cut, SceneInput& input, RestShape& rest) {
  const size_t before = static_cast<size_t>(input.garment.positions.rows());
  rest = {cut.garment.mesh.positions, cut.garment.rest_edges};
  input.garment = {interpolated(cut, input.garment.positions), cut.garment.mesh.triangles};
  if (input.start.rows() > 0) input.start = interpolated(cut, input.start);
  for (std::vector<int>& pin : input.pins) {
    std::vector<char> is_pinned(before, 0);
    for (const int v : pin) is_pinned[v] = 1;
    for (size_t v = before; v < cut.vertices.size(); ++v) {
      bool all = true;
      for (int k = 0; k < 3; ++k) all = all && (cut.vertices[v].share[k] == 0.0 || is_pinned[cut.vertices[v].from[k]]);
      if (all) pin.push_back(static_cast<int>(v));
    }
  }
  if (!input.offsets.empty()) {
    std::vector<double> offsets;
    for (const CutVertex& at : cut.vertices) {
      double offset = 0.0;
      for (int k = 0; k < 3; ++k) offset += at.share[k] * input.offsets[at.from[k]];
      offsets.push_back(offset);
    }
    input.offsets = std::move(offsets);
  }
  if (!input.paint.empty()) {
    std::vector<double> paint;
    for (const int t : cut.source) paint.push_back(input.paint[t]);
    input.paint = std::move(paint);
  }
  input.as_read.reset();
  input.authored.reset();
  input.loops = cut.garment.loops;
  input.seams = cut.garment.seams;
}

}  // namespace ease
