#include "apps/garment_pins.h"

#include <algorithm>

namespace ease {

void GarmentPins::set(const Scene& scene, const SceneInput& input, const std::vector<PinAnchor>& before,
                      const Positions& x, const Positions& surface) {
  anchors_.clear();
  std::vector<int> tied;  // those that are new
  for (size_t k = 0; k < input.pins.size(); ++k)
    for (const int v : input.pins[k]) {
      const bool to_body = scene.garment.pins[k].to_body;
      const auto held = std::find_if(before.begin(), before.end(), [&](const PinAnchor& anchor) {
        return anchor.vertex == v && (anchor.triangle >= 0) == to_body;
      });
      if (held != before.end())
        anchors_.push_back(*held);
      else if (to_body)
        tied.push_back(v);
      else
        anchors_.push_back({v, -1, x.row(v)});
    }
  const std::vector<BodyTie> ties = tieToBody(tied, x, surface, input.body_triangles);
  for (size_t i = 0; i < tied.size(); ++i) anchors_.push_back({tied[i], ties[i].triangle, ties[i].local});
  pins_.vertices.clear();
  for (const PinAnchor& anchor : anchors_) pins_.vertices.push_back(anchor.vertex);
}

const Pins& GarmentPins::at(const BodyMoment* body) {
  pins_.positions.clear();
  for (const PinAnchor& anchor : anchors_)
    pins_.positions.push_back(anchor.triangle < 0 ? anchor.local : placeOf({anchor.triangle, anchor.local}, *body));
  return pins_;
}

}  // namespace ease
