// Tool 7 by mouse: lines for the sewing pattern, from edge to edge by way of points, or closed.
#pragma once

#include <optional>

#include "apps/studio/tool.h"

namespace ease {

class SeamTool : public Tool {
 public:
  using Tool::Tool;

  std::string hint() const override;
  void hover(const Pointer& pointer) override;
  void press(const Pointer& pointer) override;
  void finish() override;
  void back() override;
  void cancel() override;
  void remove() override;
  bool isDrawing() const override { return !points_.empty(); }
  void addMarks(Marks& marks) const override;

 private:
  struct Point {
    SurfacePlace place;  // on the garment
    Vec3 made;           // m
  };
  void end(const std::string& to);
  void forget();

  std::string from_;  // loop that it begins at; empty: closed
  Vec3 from_at_;      // where it was clicked, as shown, m
  std::vector<Point> points_;
  std::optional<LoopHit> loop_;
  std::optional<int> seam_;  // under the pointer
  std::optional<Hit> cursor_;
  std::string picked_name_;
  std::shared_ptr<const MadeGarment> of_;  // the garment that the points lie on
};

}  // namespace ease
