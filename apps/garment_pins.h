// The pins of a scene in time: vertices that follow the nearest point of the body, or stay where they are.
#pragma once

#include <vector>

#include "apps/scene.h"
#include "collision/body_pins.h"
#include "solver/step/time_step.h"

namespace ease {

/// What holds a vertex: a tie to the body, or, with triangle -1, `local` itself, m.
struct PinAnchor {
  int vertex, triangle;
  Vec3 local;
};

class GarmentPins {
 public:
  /// Pins the scene's vertices: those that `before` holds in the same way as it says, the others where they are in `x`;
  /// `surface`: the body's then, m, of no use without a body.
  void set(const Scene& scene, const SceneInput& input, const std::vector<PinAnchor>& before, const Positions& x,
           const Positions& surface);

  const std::vector<PinAnchor>& anchors() const { return anchors_; }
  /// In the order of at().
  const std::vector<int>& vertices() const { return pins_.vertices; }

  /// Where they are at a moment; `body`: null without one.
  const Pins& at(const BodyMoment* body);

 private:
  std::vector<PinAnchor> anchors_;
  Pins pins_;
};

}  // namespace ease
