#include "apps/studio/brush_tool.h"

#include <fmt/format.h>

#include "garment/brush.h"

namespace ease {

namespace {

/// Colours of a stroke that is being drawn: more and less.
constexpr Rgb kMore = {230, 159, 0}, kLess = {0, 114, 178};

Rgb mixed(const Rgb& a, const Rgb& b, double share) {
  Rgb color;
  for (int k = 0; k < 3; ++k) color[k] = static_cast<std::uint8_t>(a[k] + share * (b[k] - a[k]));
  return color;
}

}  // namespace

std::string BrushTool::hint() const {
  const ToolSettings& set = studio_.settings;
  if (kind_ == PartKind::paint)
    return fmt::format("Drag over the cloth: {:.2f} times as much; Shift: as much less. [ and ] change the radius",
                       set.scale);
  return fmt::format(
      "Drag over the cloth: at least {:.0f} mm from the body; Shift: back to {:.0f} mm. [ ] change the radius",
      1000 * set.offset, 1000 * generalOffset());
}

double BrushTool::value() const {
  const ToolSettings& set = studio_.settings;
  if (kind_ == PartKind::paint) return opposite_ ? 1.0 / set.scale : set.scale;
  return opposite_ ? generalOffset() : set.offset;
}

void BrushTool::press(const Pointer& pointer) {
  stroke_.clear();
  if (!studio_.stage.hasCloth()) return studio_.refuse("there is no garment yet: draw boundaries, then click a region");
  if (studio_.settings.radius <= 0.0) return studio_.refuse("a brush without radius paints nothing: give it a radius");
  cursor_ = studio_.stage.hitCloth(pointer.x, pointer.y);
  if (!cursor_) return studio_.refuse("that is not on the cloth: the brush acts on the garment");
  opposite_ = pointer.shift;
  stroke_.push_back(cursor_->made);
}

void BrushTool::drag(const Pointer& pointer) {
  cursor_ = studio_.stage.hitCloth(pointer.x, pointer.y);
  if (stroke_.empty() || !cursor_) return;
  if ((cursor_->made - stroke_.back()).norm() >= 0.25 * studio_.settings.radius) stroke_.push_back(cursor_->made);
}

void BrushTool::release(const Pointer&) {
  if (stroke_.empty()) return;
  const std::vector<Vec3> stroke = std::exchange(stroke_, {});
  const double radius = studio_.settings.radius;
  const auto with = [&](const std::string& text, const std::vector<Vec3>& points) {
    return kind_ == PartKind::paint ? withPaint(text, points, radius, value())
                                    : withComfort(text, points, radius, value());
  };
  std::string text = with(studio_.text(), stroke);
  if (studio_.settings.mirror) text = with(text, mirrored(stroke));
  studio_.gesture(text, kind_ == PartKind::paint ? "paint" : "comfort");
}

void BrushTool::addMarks(Marks& marks) const {
  if (!studio_.stage.hasCloth()) return;
  const double radius = studio_.settings.radius;
  if (cursor_ && radius > 0.0) {
    marks.lines.push_back(ringAround(cursor_->at, cursor_->normal, radius, kHoverColor));
    marks.lines.push_back(ringAround(cursor_->at, cursor_->normal, 0.5 * radius, kPointColor));
  }
  if (stroke_.empty()) return;
  std::vector<Brush> brushes = {{stroke_.front(), radius, value(), stroke_}};
  if (studio_.settings.mirror) brushes.push_back({mirrored(stroke_.front()), radius, value(), mirrored(stroke_)});
  const TriangleMesh& made = studio_.stage.clothAsMade();
  for (Eigen::Index t = 0; t < made.triangles.rows(); ++t) {
    Vec3 centroid = Vec3::Zero();
    for (int k = 0; k < 3; ++k) centroid += made.positions.row(made.triangles(t, k)) / 3.0;
    double weight = 0.0;
    for (const Brush& brush : brushes) weight = std::max(weight, brushWeight(brush, centroid));
    marks.cloth_colors.push_back(mixed(LiveView::kClothColor, opposite_ ? kLess : kMore, weight));
  }
}

}  // namespace ease
