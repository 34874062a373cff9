#include "apps/studio/boundary_tool.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ease {

namespace {

constexpr double kSamePoint = 0.02;  // m: a click closes the loop only this near to its first point in space too

}  // namespace

std::string BoundaryTool::hint() const {
  if (!points_.empty() && points_.size() < 3)
    return "Click further points around the body; Backspace takes one back, Esc drops the loop";
  if (!points_.empty()) return "Click on, or close the loop: click its first point, or Enter";
  return "Click points around the body. On loops that are there: drag a point, Ctrl+click inserts one, Del removes the "
         "last one touched";
}

const std::vector<LoopRequest>* BoundaryTool::requests() const {
  const auto& tools = studio_.scene().garment.tools;
  return tools ? &tools->boundaries : nullptr;
}

Vec3 BoundaryTool::shown(const Vec3& made) const {
  const SurfacePlace place = nearestPlace(made, studio_.stage.firstPose(), studio_.stage.bodyTriangles());
  return placeOn(place, studio_.stage.body(), studio_.stage.bodyTriangles());
}

std::optional<BoundaryTool::Point> BoundaryTool::pointAt(const Pointer& pointer) const {
  const std::optional<Hit> hit = studio_.stage.hitBody(pointer.x, pointer.y);
  if (!hit) return std::nullopt;
  const auto edges = studio_.bodyTopology().triangle_edges.row(hit->place.triangle);
  const int node = studio_.bodyPaths().nearestAmong({edges[0], edges[1], edges[2]}, hit->made);
  return Point{node, hit->made};
}

EdgeCurve BoundaryTool::pathBetween(int from, int to) const {
  EdgeCurve curve;
  curve.is_closed = false;
  if (from == to) return curve;
  if (const auto nodes = studio_.bodyPaths().shortest(from, to)) curve = studio_.bodyPaths().curve(*nodes, false);
  return curve;
}

void BoundaryTool::hover(const Pointer& pointer) {
  cursor_ = pointAt(pointer);
  to_cursor_ = to_first_ = {};
  if (!cursor_ || points_.empty()) return;
  to_cursor_ = pathBetween(points_.back().node, cursor_->node);
  if (points_.size() >= 2) to_first_ = pathBetween(cursor_->node, points_.front().node);
}

/// Makes the list of the points of all loops that are given by points.
void BoundaryTool::showHandles() {
  if (handles_of_ == studio_.textRevision()) return;
  handles_of_ = studio_.textRevision();
  handles_.clear();
  if (!requests()) return;
  for (const LoopRequest& request : *requests()) {
    handles_.emplace_back();
    for (const Vec3& point : request.points)
      handles_.back().push_back(nearestPlace(point, studio_.stage.firstPose(), studio_.stage.bodyTriangles()));
  }
}

std::optional<BoundaryTool::Handle> BoundaryTool::handleAt(const Pointer& pointer) const {
  for (size_t b = 0; b < handles_.size(); ++b)
    for (size_t p = 0; p < handles_[b].size(); ++p) {
      const Vec3 at = placeOn(handles_[b][p], studio_.stage.body(), studio_.stage.bodyTriangles());
      if (studio_.stage.isAt(at, pointer.x, pointer.y)) return Handle{static_cast<int>(b), static_cast<int>(p)};
    }
  return std::nullopt;
}

void BoundaryTool::press(const Pointer& pointer) {
  showHandles();
  if (points_.empty()) {
    if (pointer.control) return insertAt(pointer);
    selected_ = handleAt(pointer);
    drags_ = selected_.has_value();
    if (drags_) return;
  }
  const std::optional<Point> point = pointAt(pointer);
  if (!point) return studio_.refuse("that is not on the body: click on the body");
  if (points_.size() >= 3 && (point->made - points_.front().made).norm() < kSamePoint &&
      studio_.stage.isAt(shown(points_.front().made), pointer.x, pointer.y))
    return close();
  if (!points_.empty()) {
    const EdgeCurve path = pathBetween(points_.back().node, point->node);
    if (path.points.size() < 2)
      return studio_.refuse("that is the last point, or a part of the body that is not connected: click further on");
    paths_.push_back(path);
  }
  points_.push_back(*point);
  to_cursor_ = to_first_ = {};
  studio_.say(hint());
}

void BoundaryTool::drag(const Pointer& pointer) {
  if (!drags_) return;
  cursor_ = pointAt(pointer);
  if (cursor_)
    handles_[selected_->boundary][selected_->point] =
        nearestPlace(cursor_->made, studio_.stage.firstPose(), studio_.stage.bodyTriangles());
}

void BoundaryTool::release(const Pointer& pointer) {
  if (!std::exchange(drags_, false)) return;
  const std::optional<Point> point = pointAt(pointer);
  handles_of_ = -1;
  if (!point) return studio_.refuse("let the point go on the body");
  std::vector<Vec3> points = (*requests())[selected_->boundary].points;
  if ((points[selected_->point] - point->made).norm() < 0.002)
    return studio_.say("this point is selected: Del removes it, dragging moves it");
  points[selected_->point] = point->made;
  changePoints(selected_->boundary, points, "move a point");
}

void BoundaryTool::changePoints(int boundary, const std::vector<Vec3>& points, const char* gesture) {
  std::string text = withBoundaryPoints(studio_.text(), boundary, points);
  const int other = studio_.settings.mirror ? mirrorImageOf(studio_.scene(), boundary) : -1;
  if (other >= 0) text = withBoundaryPoints(text, other, mirrored(points));
  studio_.gesture(text, gesture);
}

/// Inserts a point between the two of the loop that is under the pointer between which it lies.
void BoundaryTool::insertAt(const Pointer& pointer) {
  const std::optional<Point> point = pointAt(pointer);
  if (!point || !requests()) return studio_.refuse("Ctrl+click on a loop inserts a point");
  constexpr double kNearLoop = 0.04;  // m
  double least = kNearLoop;
  int boundary = -1, after = -1;
  for (size_t b = 0; b < requests()->size(); ++b) {
    const std::vector<Vec3>& points = (*requests())[b].points;
    for (size_t p = 0; p < points.size(); ++p) {  // the detour by way of the new point
      const Vec3 &from = points[p], &to = points[(p + 1) % points.size()];
      const double detour = (point->made - from).norm() + (to - point->made).norm() - (to - from).norm();
      if (detour >= least) continue;
      least = detour;
      boundary = static_cast<int>(b);
      after = static_cast<int>(p);
    }
  }
  if (boundary < 0) return studio_.refuse("no loop through points is near: Ctrl+click on such a loop inserts a point");
  if (handleAt(pointer)) return studio_.refuse("there is a point already: Ctrl+click between two points inserts one");
  std::vector<Vec3> points = (*requests())[boundary].points;
  points.insert(points.begin() + after + 1, point->made);
  selected_ = Handle{boundary, after + 1};
  changePoints(boundary, points, "insert a point");
}

void BoundaryTool::remove() {
  if (!selected_ || !requests() || selected_->boundary >= static_cast<int>(requests()->size()))
    return studio_.refuse("click a point of a loop first; Del then removes it");
  std::vector<Vec3> points = (*requests())[selected_->boundary].points;
  if (points.size() <= 3)
    return studio_.refuse("a loop needs three points; remove the whole loop in the list of parts");
  points.erase(points.begin() + selected_->point);
  const int boundary = selected_->boundary;
  selected_.reset();
  changePoints(boundary, points, "remove a point");
}

void BoundaryTool::close() {
  if (points_.empty()) return studio_.refuse("nothing to close: click points around the body first");
  if (points_.size() < 3)
    return studio_.refuse("a loop needs at least three points; it has " + std::to_string(points_.size()));
  std::vector<Vec3> points;
  for (const Point& point : points_) points.push_back(point.made);
  const std::string name = freeName(studio_.scene(), PartKind::boundary);
  std::string text = withBoundary(studio_.text(), name, points);
  if (studio_.settings.mirror && onOneSide(points)) text = withBoundary(text, name + " mirrored", mirrored(points));
  if (studio_.gesture(text, "boundary '" + name + "'")) forget();
}

void BoundaryTool::back() {
  if (points_.empty()) return studio_.refuse("no point to take back");
  points_.pop_back();
  if (!paths_.empty()) paths_.pop_back();
  to_cursor_ = to_first_ = {};
  studio_.say(hint());
}

void BoundaryTool::cancel() {
  forget();
  selected_.reset();
  studio_.say(hint());
}

void BoundaryTool::forget() {
  points_.clear();
  paths_.clear();
  to_cursor_ = to_first_ = {};
}

void BoundaryTool::addMarks(Marks& marks) const {
  const_cast<BoundaryTool*>(this)->showHandles();
  const Positions& body = studio_.stage.body();
  const auto line = [&](const EdgeCurve& curve, const Rgb& color) {
    if (curve.points.size() >= 2) marks.lines.push_back({placed(curve, body), false, color, 3.0});
  };
  for (size_t b = 0; b < handles_.size(); ++b)
    for (size_t p = 0; p < handles_[b].size(); ++p) {
      const bool is_selected =
          selected_ && selected_->boundary == static_cast<int>(b) && selected_->point == static_cast<int>(p);
      marks.dots.push_back(
          {placeOn(handles_[b][p], body, studio_.stage.bodyTriangles()), is_selected ? kHoverColor : kLoopColor});
    }
  for (const EdgeCurve& path : paths_) line(path, kLoopColor);
  line(to_cursor_, kHoverColor);
  line(to_first_, kHoverColor);
  for (const Point& point : points_)
    marks.dots.push_back({placed({{studio_.bodyPaths().point(point.node)}, false}, body).front(), kPointColor});
  if (cursor_)
    marks.dots.push_back({placed({{studio_.bodyPaths().point(cursor_->node)}, false}, body).front(), kHoverColor});
}

}  // namespace ease
