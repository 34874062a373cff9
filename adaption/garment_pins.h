// Pinned vertices in time: each follows the nearest point of the body, or stays where it is.
#pragma once

#include <vector>

#include "collision/body_pins.h"
#include "solver/step/state.h"

namespace ease {

/// Vertices that are pinned in one way.
struct PinnedVertices {
  std::vector<int> vertices;
  bool to_body = true;  // follow the body; otherwise stay in space
};

/// What holds a vertex: a tie to a triangle of the body (body_pins.h), or, with triangle -1, the place `local`, m.
struct PinAnchor {
  int vertex, triangle;
  Vec3 local;
};

class GarmentPins {
 public:
  /// Pins the vertices.  One that `earlier` holds in the same way, to the body or in space, keeps that anchor; any
  /// other is anchored where it is in `x`.  `body`: positions of the body's vertices now, m, and its triangles; not
  /// used where nothing is pinned to the body.
  void set(const std::vector<PinnedVertices>& pins, const std::vector<PinAnchor>& earlier, const Positions& x,
           const Positions& body, const Triangles& body_triangles);

  const std::vector<PinAnchor>& anchors() const { return anchors_; }
  /// In the order in which at() has their positions.
  const std::vector<int>& vertices() const { return pins_.vertices; }

  /// Where the pinned vertices are at a moment.  `body`: null without one.
  const Pins& at(const BodyMoment* body);

 private:
  std::vector<PinAnchor> anchors_;
  Pins pins_;
};

}  // namespace ease
