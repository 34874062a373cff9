// Tool 6 by mouse: pins an edge of the garment, or the cloth within a ball, to the body.
#pragma once

#include <optional>

#include "apps/studio/tool.h"

namespace ease {

class PinTool : public Tool {
 public:
  using Tool::Tool;

  std::string hint() const override;
  void hover(const Pointer& pointer) override;
  void press(const Pointer& pointer) override;
  void addMarks(Marks& marks) const override;

 private:
  /// The scene's pin of a loop, or one whose ball holds the point (as made, m); -1: none.
  int pinOfLoop(const std::string& loop) const;
  int pinAt(const Vec3& made) const;

  std::optional<LoopHit> loop_;
  std::optional<Hit> cursor_;
};

}  // namespace ease
