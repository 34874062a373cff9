// Tool 2 by mouse: the part of the body that becomes cloth.
#pragma once

#include "apps/studio/tool.h"

namespace ease {

class RegionTool : public Tool {
 public:
  using Tool::Tool;

  std::string hint() const override;
  void hover(const Pointer& pointer) override;
  void press(const Pointer& pointer) override;
  void addMarks(Marks& marks) const override;

 private:
  void findParts();

  std::vector<int> part_of_;  // of every triangle of the body; -1 on a loop
  int parts_of_ = -1;         // mesh revision
  int part_ = -1;             // under the pointer
};

}  // namespace ease
