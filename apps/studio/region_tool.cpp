#include "apps/studio/region_tool.h"

namespace ease {

std::string RegionTool::hint() const {
  return "Click the part of the body, between the boundaries, that becomes cloth";
}

/// Numbers the parts into which the loops divide the body.
void RegionTool::findParts() {
  if (parts_of_ == studio_.meshRevision()) return;
  parts_of_ = studio_.meshRevision();
  const Topology& topology = studio_.bodyTopology();
  const int count = static_cast<int>(studio_.bodyMesh().triangles.rows());
  constexpr int kUnknown = -2;
  part_of_.assign(count, kUnknown);
  if (studio_.made())
    for (const BoundaryLoop& loop : studio_.made()->loops)
      for (const EdgePoint& point : loop.curve.points)
        for (const int t : topology.edges[point.edge].triangle) part_of_[t] = -1;
  int parts = 0;
  std::vector<int> front;
  for (int first = 0; first < count; ++first) {
    if (part_of_[first] != kUnknown) continue;
    part_of_[first] = parts;
    front.push_back(first);
    while (!front.empty()) {
      const int t = front.back();
      front.pop_back();
      for (int k = 0; k < 3; ++k) {
        const int across = topology.edges[topology.triangle_edges(t, k)].triangleAcross(t);
        if (across < 0 || part_of_[across] != kUnknown) continue;
        part_of_[across] = parts;
        front.push_back(across);
      }
    }
    ++parts;
  }
}

void RegionTool::hover(const Pointer& pointer) {
  findParts();
  const std::optional<Hit> hit = studio_.stage.hitBody(pointer.x, pointer.y);
  part_ = hit ? part_of_[hit->place.triangle] : -1;
}

void RegionTool::press(const Pointer& pointer) {
  const std::optional<Hit> hit = studio_.stage.hitBody(pointer.x, pointer.y);
  if (!hit) return studio_.refuse("that is not on the body: click the part of the body that becomes cloth");
  if (!studio_.scene().garment.tools) return studio_.refuse("draw boundaries first (tool 1): the cloth ends there");
  studio_.gesture(withRegion(studio_.text(), hit->made), "region");
}

void RegionTool::addMarks(Marks& marks) const {
  if (part_ < 0 || !studio_.made() || studio_.made()->loops.empty()) return;
  for (const int part : part_of_) marks.body_colors.push_back(part == part_ ? kRegionColor : LiveView::kBodyColor);
}

}  // namespace ease
