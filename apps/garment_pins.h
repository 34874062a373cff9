// The pins of a scene in time: vertices that follow the nearest point of the body, or stay where they are.
#pragma once

#include <functional>
#include <vector>

#include "apps/scene.h"
#include "collision/body_pins.h"
#include "solver/step/time_step.h"

namespace ease {

class GarmentPins {
 public:
  /// Pins those vertices of the scene's that `chosen` says, where they are in `x`; `surface`: the body's then, m, of no
  /// use without a body.
  void add(const Scene& scene, const SceneInput& input, const Positions& x, const Positions& surface,
           const std::function<bool(int)>& chosen);

  /// In the order of at().
  const std::vector<int>& vertices() const { return pins_.vertices; }

  /// Where they are at a moment; `body`: null without one.
  const Pins& at(const BodyMoment* body);

 private:
  struct Group {
    BodyPins tied;
    std::vector<Vec3> fixed;  // m
  };
  std::vector<Group> groups_;
  Pins pins_;  // group by group, tied ones first
};

}  // namespace ease
