// Tool 3 by mouse: pulls a loop out to a skirt or a wide sleeve.
#pragma once

#include <optional>

#include "apps/studio/tool.h"

namespace ease {

class ExtensionTool : public Tool {
 public:
  using Tool::Tool;

  std::string hint() const override;
  void hover(const Pointer& pointer) override;
  void press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override { drag_.reset(); }
  void addMarks(Marks& marks) const override;

 private:
  struct Drag {
    int loop, number;          // in MadeGarment::edges; of the extension that there is, -1: none
    double length, scale;      // of that extension
    std::vector<Vec3> points;  // of the loop, as shown, m
    Vec3 centre, axis;         // unit axis, away from the garment
    double from_x, from_y;     // pixels
    double more = 0.0, wider = 1.0;
    bool moved = false;
  };
  std::vector<Vec3> pulledLoop() const;
  int extensionOf(const std::string& loop) const;
  /// The boundary on the other side of the body; empty: there is none.
  std::string mirrorImageOf(const std::string& loop) const;
  Vec3 axisOf(const std::vector<int>& loop, const Vec3& centre, const std::vector<Vec3>& points) const;

  int hovered_ = -1;
  std::optional<Drag> drag_;
};

}  // namespace ease
