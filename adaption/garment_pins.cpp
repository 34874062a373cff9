#include "adaption/garment_pins.h"

#include <algorithm>

namespace ease {

void GarmentPins::set(const std::vector<PinnedVertices>& pins, const std::vector<PinAnchor>& earlier,
                      const Positions& x, const Positions& body, const Triangles& body_triangles) {
  anchors_.clear();
  std::vector<int> newly_tied;
  for (const PinnedVertices& pinned : pins)
    for (const int v : pinned.vertices) {
      const auto anchor = std::find_if(earlier.begin(), earlier.end(), [&](const PinAnchor& candidate) {
        return candidate.vertex == v && (candidate.triangle >= 0) == pinned.to_body;
      });
      if (anchor != earlier.end())
        anchors_.push_back(*anchor);
      else if (pinned.to_body)
        newly_tied.push_back(v);
      else
        anchors_.push_back({v, -1, x.row(v)});
    }
  const std::vector<BodyTie> ties = tieToBody(newly_tied, x, body, body_triangles);
  for (size_t i = 0; i < newly_tied.size(); ++i) anchors_.push_back({newly_tied[i], ties[i].triangle, ties[i].local});
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
