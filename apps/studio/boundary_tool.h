// Tool 1 by mouse: closed loops on the body through clicked points, joined by shortest paths.
#pragma once

#include <optional>

#include "apps/studio/tool.h"

namespace ease {

class BoundaryTool : public Tool {
 public:
  using Tool::Tool;

  std::string hint() const override;
  void hover(const Pointer& pointer) override;
  void press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void finish() override { close(); }
  void back() override;
  void cancel() override;
  void remove() override;
  bool isDrawing() const override { return !points_.empty(); }
  void addMarks(Marks& marks) const override;

 private:
  /// A point that was clicked: a node of the paths, and its place in the first pose, m.
  struct Point {
    int node;
    Vec3 made;
  };
  /// A point of a loop that is there already.
  struct Handle {
    int boundary, point;
  };

  std::optional<Point> pointAt(const Pointer& pointer) const;
  Vec3 shown(const Vec3& made) const;
  EdgeCurve pathBetween(int from, int to) const;
  std::optional<Handle> handleAt(const Pointer& pointer) const;
  void close();
  void insertAt(const Pointer& pointer);
  void changePoints(int boundary, const std::vector<Vec3>& points, const char* gesture);
  const std::vector<LoopRequest>* requests() const;
  void showHandles();
  void forget();

  std::vector<Point> points_;     // of the loop that is being drawn
  std::vector<EdgeCurve> paths_;  // from each point to the next
  std::optional<Point> cursor_;
  EdgeCurve to_cursor_, to_first_;
  std::optional<Handle> selected_;
  bool drags_ = false;
  std::vector<std::vector<SurfacePlace>> handles_;  // places of the points of all loops
  int handles_of_ = -1;                             // text revision
};

}  // namespace ease
