#include "apps/studio/seam_tool.h"

#include "garment/looped_mesh.h"

namespace ease {

std::string SeamTool::hint() const {
  if (!from_.empty()) return "Click points that the seam passes, then the edge where it ends; Esc drops it";
  if (!points_.empty()) return "Click further points around the garment; Enter closes the seam, Esc drops it";
  if (!picked_name_.empty()) return "Seam '" + picked_name_ + "' is picked; Del removes it";
  return "Click an edge of the garment where the seam begins, cloth for a closed seam around it, or a seam to pick it";
}

void SeamTool::hover(const Pointer& pointer) {
  loop_ = studio_.stage.hitLoop(pointer.x, pointer.y);
  const bool picks = !loop_ && from_.empty() && points_.empty();
  seam_ = picks ? studio_.stage.hitSeam(pointer.x, pointer.y) : std::nullopt;
  cursor_ = loop_ || seam_ ? std::nullopt : studio_.stage.hitCloth(pointer.x, pointer.y);
}

void SeamTool::press(const Pointer& pointer) {
  if (!studio_.stage.hasCloth()) return studio_.refuse("there is no garment yet: draw boundaries, then click a region");
  if (!studio_.scene().garment.tools)
    return studio_.refuse("this garment comes from a file or is built in; only one made of boundaries can have seams");
  hover(pointer);
  if (of_ && of_->input.garment.triangles != studio_.stage.clothAsMade().triangles) forget();
  picked_name_.clear();
  if (seam_) {
    picked_name_ = studio_.stage.made().scene.garment.tools->seams[*seam_].name;
    picked_ = Part{PartKind::seam, *seam_, picked_name_};
    return studio_.say(hint());
  }
  if (loop_) {
    const std::string name = studio_.stage.made().edges[loop_->loop].name;
    if (!from_.empty()) return end(name);
    if (!points_.empty()) return studio_.refuse("a seam that began on the cloth is closed: Enter closes it");
    from_ = name;
    from_at_ = loop_->at;
  } else if (cursor_) {
    points_.push_back({cursor_->place, cursor_->made});
  } else {
    return studio_.refuse("that is not on the cloth: click the garment, or an edge of it");
  }
  of_ = studio_.made();
  studio_.say(hint());
}

void SeamTool::end(const std::string& to) {
  std::vector<Vec3> points;
  for (const Point& point : points_) points.push_back(point.made);
  const std::string name = freeName(studio_.scene(), PartKind::seam);
  std::string text = withSeam(studio_.text(), name, from_, to, points);
  if (studio_.settings.mirror && onOneSide(points)) {
    // The loops on the other side are those whose middles lie nearest to the mirrored ones.
    const auto across = [&](const std::string& loop) {
      const MadeGarment& made = studio_.stage.made();
      const auto middle = [&](const NamedLoop& edge) {
        Vec3 sum = Vec3::Zero();
        for (const Vec3& x : positionsOf(edge.vertices, made.input.garment.positions)) sum += x;
        return Vec3(sum / static_cast<double>(edge.vertices.size()));
      };
      const Vec3 wanted = mirrored(middle(made.edges[loopNamed(made.edges, loop, "seam")]));
      size_t nearest = 0;
      for (size_t k = 0; k < made.edges.size(); ++k)
        if ((middle(made.edges[k]) - wanted).norm() < (middle(made.edges[nearest]) - wanted).norm()) nearest = k;
      return made.edges[nearest].name;
    };
    text = withSeam(text, name + " mirrored", from_.empty() ? "" : across(from_), to.empty() ? "" : across(to),
                    mirrored(points));
  }
  if (studio_.gesture(text, "seam '" + name + "'")) forget();
}

void SeamTool::finish() {
  if (!from_.empty()) return studio_.refuse("click the edge where the seam ends");
  if (points_.size() < 3) return studio_.refuse("a closed seam needs at least three points");
  end("");
}

void SeamTool::back() {
  if (points_.empty())
    from_.clear();
  else
    points_.pop_back();
  studio_.say(hint());
}

void SeamTool::cancel() {
  forget();
  studio_.say(hint());
}

void SeamTool::remove() {
  for (const Part& part : partsOf(studio_.scene())) {
    if (part.kind != PartKind::seam || part.label != picked_name_) continue;
    if (studio_.gesture(without(studio_.text(), part), "remove '" + part.label + "'")) picked_name_.clear();
    return;
  }
  studio_.refuse("pick a seam first: click it; Del then removes it");
}

void SeamTool::forget() {
  picked_name_.clear();
  from_.clear();
  points_.clear();
  of_.reset();
}

void SeamTool::addMarks(Marks& marks) const {
  if (!studio_.stage.hasCloth()) return;
  if (loop_ && loop_->loop < static_cast<int>(studio_.stage.made().edges.size()))
    marks.lines.push_back(
        {positionsOf(studio_.stage.made().edges[loop_->loop].vertices, studio_.stage.cloth()), true, kSeamColor, 6.0});
  const MadeGarment& made = studio_.stage.made();
  if (seam_ && made.input.authored && *seam_ < static_cast<int>(made.input.authored->seams.size())) {
    const Seam& seam = made.input.authored->seams[*seam_];
    marks.lines.push_back({positionsOf(seam.vertices, studio_.stage.cloth()), seam.is_closed, kHoverColor, 5.0});
  }
  if (of_ && of_->input.garment.triangles != studio_.stage.clothAsMade().triangles) return;
  std::vector<Vec3> line;
  if (!from_.empty()) line.push_back(from_at_);
  for (const Point& point : points_) {
    line.push_back(placeOn(point.place, studio_.stage.cloth(), studio_.stage.clothAsMade().triangles));
    marks.dots.push_back({line.back(), kSeamColor});
  }
  if (cursor_) line.push_back(cursor_->at);
  if (loop_ && !line.empty()) line.push_back(loop_->at);
  if (line.size() >= 2) marks.lines.push_back({line, false, kSeamColor, 3.0});
}

}  // namespace ease
