// Lets the rest shape out where the cloth is stretched beyond the limit, and nowhere else: what every triangle asks for
// (clip.h), made one mesh again (stitch.h).
#pragma once

#include <span>
#include <vector>

#include "adaption/clip.h"
#include "adaption/stitch.h"

namespace ease {

class RestAdaption {
 public:
  /// Growth counts from the cloth's first rest shape.  `limit`: delta; principal stretch is to stay below 1 + delta.
  /// `ordering`: of the mesh's systems (gradient_system.h).
  RestAdaption(Cloth& cloth, double limit, std::span<const int> ordering);

  /// Goes on with what an earlier adaption of the same first rest shape remembered.
  void resume(const std::vector<Mat2>& wanted_edges) { stitcher_.restore(wanted_edges); }

  /// Scales what every triangle asks for by its factor, above or below 1, and adapts the rest shape to that.
  void rescale(const std::vector<double>& scales, int iterations = Stitcher::kRescaleIterations) {
    stitcher_.rescale(cloth_, scales, iterations);
  }

  /// Adapts the cloth's rest shape to its present stretch; returns whether it grew.
  bool adapt(const std::vector<Stretch>& stretch);

  /// Flat rest edges that every triangle has asked for so far, m (stitch.h).
  const std::vector<Mat2>& wantedEdges() const { return stitcher_.wanted(); }
  /// Triangles that were over the limit at the last adapt() and have grown as far as they may.
  int fullyGrown() const { return clip_.fullyGrown(); }

 private:
  Cloth& cloth_;
  StretchClip clip_;
  Stitcher stitcher_;
  std::vector<Mat2> growth_;
};

}  // namespace ease
