// Tools 4 and 5 by mouse: paints how much cloth there is, or how far it keeps from the body.  A stroke is one table.
#pragma once

#include <optional>

#include "apps/studio/tool.h"

namespace ease {

class BrushTool : public Tool {
 public:
  BrushTool(PartKind kind, Studio& studio) : Tool(studio), kind_(kind) {}

  std::string hint() const override;
  void hover(const Pointer& pointer) override { cursor_ = studio_.stage.hitCloth(pointer.x, pointer.y); }
  void press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override { stroke_.clear(); }
  void addMarks(Marks& marks) const override;

 private:
  double value() const;
  double generalOffset() const { return studio_.scene().collision.offset; }

  const PartKind kind_;  // paint or comfort
  std::optional<Hit> cursor_;
  std::vector<Vec3> stroke_;  // on the garment as it was made, m
  bool opposite_ = false;     // less cloth; or the general offset
};

}  // namespace ease
