#include "apps/studio/pin_tool.h"

#include "garment/brush.h"

namespace ease {

std::string PinTool::hint() const {
  return "Click an edge of the garment, or cloth: it follows the body. A click on what is pinned frees it";
}

void PinTool::hover(const Pointer& pointer) {
  loop_ = studio_.stage.hitLoop(pointer.x, pointer.y);
  cursor_ = loop_ ? std::nullopt : studio_.stage.hitCloth(pointer.x, pointer.y);
}

int PinTool::pinOfLoop(const std::string& loop) const {
  const std::vector<PinScene>& pins = studio_.scene().garment.pins;
  for (size_t k = 0; k < pins.size(); ++k)
    if (const auto* name = std::get_if<std::string>(&pins[k].what); name && *name == loop) return static_cast<int>(k);
  return -1;
}

int PinTool::pinAt(const Vec3& made) const {
  const std::vector<PinScene>& pins = studio_.scene().garment.pins;
  for (size_t k = 0; k < pins.size(); ++k)
    if (const auto* ball = std::get_if<Brush>(&pins[k].what); ball && distanceTo(*ball, made) <= ball->radius)
      return static_cast<int>(k);
  return -1;
}

void PinTool::press(const Pointer& pointer) {
  if (!studio_.stage.hasCloth()) return studio_.refuse("there is no garment yet: draw boundaries, then click a region");
  hover(pointer);
  const std::string& text = studio_.text();
  if (loop_) {
    const std::string name = studio_.stage.made().edges[loop_->loop].name;
    const int pinned = pinOfLoop(name);
    studio_.gesture(pinned < 0 ? withPinnedLoop(text, name) : without(text, {PartKind::pin, pinned, ""}),
                    (pinned < 0 ? "pin '" : "free '") + name + "'");
    return;
  }
  if (!cursor_) return studio_.refuse("that is not on the cloth: click the garment, or an edge of it");
  const int pinned = pinAt(cursor_->made);
  if (pinned >= 0) {
    studio_.gesture(without(text, {PartKind::pin, pinned, ""}), "free");
    return;
  }
  const double radius = studio_.settings.radius;
  if (radius <= 0.0) return studio_.refuse("a ball without radius pins nothing: give it a radius");
  std::string with = withPinnedBall(text, cursor_->made, radius);
  if (studio_.settings.mirror && std::abs(cursor_->made.x()) > radius)
    with = withPinnedBall(with, mirrored(cursor_->made), radius);
  studio_.gesture(with, "pin");
}

void PinTool::addMarks(Marks& marks) const {
  if (!studio_.stage.hasCloth()) return;
  if (loop_ && loop_->loop < static_cast<int>(studio_.stage.made().edges.size()))
    marks.lines.push_back(
        {positionsOf(studio_.stage.made().edges[loop_->loop].vertices, studio_.stage.cloth()), true, kPinColor, 6.0});
  if (cursor_) marks.lines.push_back(ringAround(cursor_->at, cursor_->normal, studio_.settings.radius, kPinColor));
}

}  // namespace ease
