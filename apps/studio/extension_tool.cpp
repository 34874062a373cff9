#include "apps/studio/extension_tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "garment/extension.h"
#include "garment/looped_mesh.h"

namespace ease {

namespace {

constexpr double kMinPull = 4.0;     // pixels: less is a click
constexpr double kMinLength = 0.01;  // m
constexpr double kMiddle = 0.3;      // of the loop's half width: pressed nearer to the axis, any way across is outward

}  // namespace

std::string ExtensionTool::hint() const {
  if (drag_ && drag_->more < -0.005)
    return fmt::format("{:.2f} m shorter, {:.2f} times as wide", -drag_->more, drag_->wider);
  if (drag_) return fmt::format("{:.2f} m longer, {:.2f} times as wide", std::max(drag_->more, 0.0), drag_->wider);
  return "Press on an edge of the garment and pull: along its axis longer, outward wider";
}

void ExtensionTool::hover(const Pointer& pointer) {
  const std::optional<LoopHit> hit = studio_.stage.hitLoop(pointer.x, pointer.y);
  hovered_ = hit ? hit->loop : -1;
}

/// The direction in which the loop leaves the garment.
Vec3 ExtensionTool::axisOf(const std::vector<int>& loop, const Vec3& centre, const std::vector<Vec3>& points) const {
  std::vector<char> is_on_loop(studio_.stage.cloth().rows(), 0);
  for (const int v : loop) is_on_loop[v] = 1;
  Vec3 inside = Vec3::Zero();
  int count = 0;
  const Triangles& triangles = studio_.stage.clothAsMade().triangles;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const auto corners = triangles.row(t);
    if (!is_on_loop[corners[0]] && !is_on_loop[corners[1]] && !is_on_loop[corners[2]]) continue;
    for (int k = 0; k < 3; ++k) inside += studio_.stage.cloth().row(corners[k]).transpose() / 3.0;
    ++count;
  }
  const Vec3 area = vectorArea(points);
  const Vec3 axis = area.norm() > 0.0 ? Vec3(area.normalized()) : Vec3(0.0, -1.0, 0.0);
  return axis.dot(centre - inside / std::max(count, 1)) < 0.0 ? Vec3(-axis) : axis;
}

void ExtensionTool::press(const Pointer& pointer) {
  drag_.reset();
  if (!studio_.stage.hasCloth()) return studio_.refuse("there is no garment yet: draw boundaries, then click a region");
  if (!studio_.scene().garment.tools)
    return studio_.refuse("this garment comes from a file or is built in; only one made of boundaries can be extended");
  const std::optional<LoopHit> hit = studio_.stage.hitLoop(pointer.x, pointer.y);
  if (!hit) return studio_.refuse("press on an edge of the garment, where cloth ends");
  const NamedLoop& loop = studio_.stage.made().edges[hit->loop];
  Drag drag{hit->loop, -1, 0.0, 1.0, positionsOf(loop.vertices, studio_.stage.cloth()), {}, {}, pointer.x, pointer.y};
  drag.centre = centreOfMass(drag.points);
  drag.axis = axisOf(loop.vertices, drag.centre, drag.points);
  drag.number = extensionOf(loop.name);
  if (drag.number >= 0) {
    const Extension& extension = studio_.scene().garment.tools->extensions[drag.number];
    drag.length = extension.length;
    drag.scale = extension.scale;
  }
  drag_ = drag;
}

void ExtensionTool::drag(const Pointer& pointer) {
  if (!drag_) return;
  const double dx = pointer.x - drag_->from_x, dy = pointer.y - drag_->from_y;
  drag_->moved = drag_->moved || std::hypot(dx, dy) >= kMinPull;
  const Projected centre = studio_.stage.project(drag_->centre);
  const Projected along = studio_.stage.project(drag_->centre + 0.1 * drag_->axis);
  double ax = along.x - centre.x, ay = along.y - centre.y;
  const double pixels = std::hypot(ax, ay);  // of 0.1 m along the axis
  if (pixels < 2.0) {
    studio_.refuse("the edge is seen along its axis: turn the view (right button), then pull");
    return;
  }
  ax /= pixels;
  ay /= pixels;
  drag_->more = 0.1 * (dx * ax + dy * ay) / pixels;
  const auto across = [&](double x, double y) { return x * ay - y * ax; };  // pixels
  double half_width = 1.0;
  for (const Vec3& point : drag_->points) {
    const Projected seen = studio_.stage.project(point);
    half_width = std::max(half_width, std::abs(across(seen.x - centre.x, seen.y - centre.y)));
  }
  const double from = across(drag_->from_x - centre.x, drag_->from_y - centre.y), pull = across(dx, dy);
  const double outward = std::abs(from) < kMiddle * half_width ? std::abs(pull) : std::copysign(1.0, from) * pull;
  drag_->wider = std::clamp(1.0 + outward / half_width, 0.1, 20.0);
  studio_.say(hint());
}

void ExtensionTool::release(const Pointer&) {
  if (!drag_) return;
  const Drag drag = *drag_;
  drag_.reset();
  if (!drag.moved) return studio_.say("keep the button pressed and pull");
  const double length = drag.length + drag.more;
  if (length < kMinLength) {
    if (drag.number < 0) return studio_.refuse("pull away from the garment: nothing was added");
    studio_.gesture(without(studio_.text(), {PartKind::extension, drag.number, ""}), "remove the extension");
    return;
  }
  const double scale = std::clamp(drag.scale * drag.wider, 0.1, 20.0);
  const std::string name = studio_.stage.made().edges[drag.loop].name;
  std::string text = withExtension(studio_.text(), drag.number, name, length, scale);
  if (const std::string other = studio_.settings.mirror ? mirrorImageOf(name) : ""; !other.empty())
    text = withExtension(text, extensionOf(other), other, length, scale);
  studio_.gesture(text, "extend '" + name + "'");
}

/// The extension of a loop that ends freely, by its number; -1: there is none.
int ExtensionTool::extensionOf(const std::string& loop) const {
  const std::vector<Extension>& extensions = studio_.scene().garment.tools->extensions;
  int number = -1;
  for (size_t k = 0; k < extensions.size(); ++k)
    if (extensions[k].loop == loop && !extensions[k].to) number = static_cast<int>(k);
  return number;
}

std::string ExtensionTool::mirrorImageOf(const std::string& loop) const {
  const std::vector<LoopRequest>& loops = studio_.scene().garment.tools->boundaries;
  for (size_t k = 0; k < loops.size(); ++k)
    if (loops[k].name == loop)
      if (const int other = ease::mirrorImageOf(studio_.scene(), static_cast<int>(k)); other >= 0)
        return loops[other].name;
  return "";
}

std::vector<Vec3> ExtensionTool::pulledLoop() const {
  std::vector<Vec3> points;
  for (const Vec3& p : drag_->points)
    points.push_back(drag_->centre + drag_->more * drag_->axis + drag_->wider * (p - drag_->centre));
  return points;
}

void ExtensionTool::addMarks(Marks& marks) const {
  if (!studio_.stage.hasCloth()) return;
  if (!drag_) {
    if (hovered_ >= 0 && hovered_ < static_cast<int>(studio_.stage.made().edges.size()))
      marks.lines.push_back(
          {positionsOf(studio_.stage.made().edges[hovered_].vertices, studio_.stage.cloth()), true, kHoverColor, 6.0});
    return;
  }
  const std::vector<Vec3> pulled = pulledLoop();
  marks.lines.push_back({pulled, true, kHoverColor, 4.0});
  const size_t every = std::max<size_t>(1, pulled.size() / 24);
  for (size_t i = 0; i < pulled.size(); i += every)
    marks.lines.push_back({{drag_->points[i], pulled[i]}, false, kHoverColor, 2.0});
}

}  // namespace ease
