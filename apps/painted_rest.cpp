#include "apps/painted_rest.h"

#include "adaption/stitch.h"

namespace ease {

namespace {

Stitcher stitcherOf(const Cloth& cloth) {
  return Stitcher(cloth, systemOrdering(cloth.vertexCount(), cloth.triangles()));
}

}  // namespace

void paintFirstRest(const std::vector<double>& paint, Cloth& cloth) {
  stitcherOf(cloth).rescale(cloth, paint);
  cloth.setFirst(RestShape(cloth.rest()));
}

RunState withPaint(const RunState& state, const std::vector<double>& more, Cloth& cloth) {
  if (more.empty()) return state;
  RunState painted = state;
  Stitcher stitcher = stitcherOf(cloth);
  cloth.setRest(state.rest);
  stitcher.restore(state.wanted_edges.empty() ? state.rest.edges : state.wanted_edges);
  stitcher.rescale(cloth, more);
  painted.rest = cloth.rest();
  painted.wanted_edges = stitcher.wanted();
  return painted;
}

}  // namespace ease
