#include "apps/garment_pins.h"

namespace ease {

void GarmentPins::add(const Scene& scene, const SceneInput& input, const Positions& x, const Positions& surface,
                      const std::function<bool(int)>& chosen) {
  std::vector<int> tied, fixed;
  for (size_t k = 0; k < input.pins.size(); ++k)
    for (const int v : input.pins[k])
      if (chosen(v)) (scene.garment.pins[k].to_body ? tied : fixed).push_back(v);
  Group& group = groups_.emplace_back(Group{BodyPins(tied, x, surface, input.body_triangles), {}});
  for (const int v : fixed) group.fixed.emplace_back(x.row(v));
  pins_.vertices.insert(pins_.vertices.end(), tied.begin(), tied.end());
  pins_.vertices.insert(pins_.vertices.end(), fixed.begin(), fixed.end());
}

const Pins& GarmentPins::at(const BodyMoment* body) {
  pins_.positions.clear();
  for (const Group& group : groups_) {
    if (body) group.tied.place(*body, pins_.positions);
    pins_.positions.insert(pins_.positions.end(), group.fixed.begin(), group.fixed.end());
  }
  return pins_;
}

}  // namespace ease
