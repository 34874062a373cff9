// A tool: what the left mouse button does, and what is shown before it does.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/studio/studio.h"
#include "viz/live_view.h"

namespace ease {

/// The pointer: pixels from the picture's upper left corner, and the keys held.
struct Pointer {
  double x = 0.0, y = 0.0;
  bool shift = false, control = false;
};

/// What a tool shows.  Colours are one a triangle, empty: as they are.
struct Marks {
  std::vector<MarkLine> lines;
  std::vector<MarkDot> dots;
  std::vector<Rgb> body_colors, cloth_colors;
};

class Tool {
 public:
  explicit Tool(Studio& studio) : studio_(studio) {}
  virtual ~Tool() = default;

  /// What to do next.
  virtual std::string hint() const = 0;
  virtual void hover(const Pointer&) {}
  virtual void press(const Pointer&) {}
  virtual void drag(const Pointer&) {}
  virtual void release(const Pointer&) {}
  /// Enter, Backspace, Escape and Delete.
  virtual void finish() {}
  virtual void back() {}
  virtual void cancel() {}
  virtual void remove() {}
  /// Whether a line has been begun and is not finished.
  virtual bool isDrawing() const { return false; }
  virtual void addMarks(Marks&) const {}
  /// A part that was picked by a click, once.
  std::optional<Part> takePicked() { return std::exchange(picked_, std::nullopt); }

 protected:
  Studio& studio_;
  std::optional<Part> picked_;
};

/// Colours of marks; the colour-blind can tell them apart (Okabe and Ito 2008).
constexpr Rgb kLoopColor = {213, 94, 0}, kHoverColor = {230, 159, 0}, kPointColor = {0, 0, 0},
              kSeamColor = {204, 121, 167}, kPinColor = {0, 158, 115}, kRegionColor = {86, 180, 233};

std::unique_ptr<Tool> makeTool(PartKind kind, Studio& studio);
/// Name, tooltip and what it does, for people.
struct ToolText {
  const char *name, *does;
};
const ToolText& textOf(PartKind kind);

/// The loops, seams and pins of the garment as it is on show, and those of a draft on the body.  `selected`: lit.
void addPartMarks(const Studio& studio, const Part* selected, Marks& marks);

/// A ring around a place on a surface, m.
MarkLine ringAround(const Vec3& at, const Vec3& normal, double radius, const Rgb& color);

/// The point on the other side of the body, x and -x.
inline Vec3 mirrored(const Vec3& point) {
  return {-point.x(), point.y(), point.z()};
}
std::vector<Vec3> mirrored(const std::vector<Vec3>& points);
/// Whether they lie on one side of the body, so that a mirrored copy does not touch them.
bool onOneSide(const std::vector<Vec3>& points);

}  // namespace ease
