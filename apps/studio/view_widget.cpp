#include "apps/studio/view_widget.h"

#include <QPainter>
#include <cmath>

#include "apps/studio/color_bar.h"
#include "solver/base/stopwatch.h"

namespace ease {

ViewWidget::ViewWidget(Studio& studio, Content content, QWidget* parent)
    : QWidget(parent), studio_(studio), content_(content) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(240, 240);
  view_.setBody(studio.bodyMesh());
}

void ViewWidget::setTool(Tool* tool) {
  tool_ = tool;
  refresh();
}

void ViewWidget::setShown(Shown shown) {
  shown_ = shown;
  refresh();
}

void ViewWidget::setSelected(const std::optional<Part>& part) {
  selected_ = part;
  refresh();
}

void ViewWidget::setPicked(std::shared_ptr<const PatternSheet> sheet, const SheetPick& pick) {
  sheet_ = std::move(sheet);
  pick_ = pick;
  refresh();
}

void ViewWidget::showBody(bool is_shown) {
  body_is_shown_ = is_shown;
  refresh();
}

void ViewWidget::showEdges(bool are_shown) {
  view_.showEdges(are_shown);
  refresh();
}

void ViewWidget::refresh() {
  is_stale_ = true;
  update();
}

PictureSize ViewWidget::pictureSize() const {
  const double ratio = devicePixelRatioF();
  return {std::max(1, static_cast<int>(width() * ratio)), std::max(1, static_cast<int>(height() * ratio))};
}

const LiveFrame* ViewWidget::frameShown() const {
  return content_ == Content::kept && kept_ ? &*kept_ : studio_.frame();
}

/// Hands over what has moved.
void ViewWidget::update3d() {
  const LiveFrame* frame = frameShown();
  const Stage& stage = studio_.stage;
  if (!frame || !stage.hasCloth()) {
    view_.moveBody(stage.body());
    view_.showBody(true);
    if (meshes_of_) view_.setGarment({});
    meshes_of_.reset();
    return;
  }
  const bool shows_rest = content_ == Content::rest;
  const Positions& garment = shows_rest ? frame->rest : frame->garment;
  if (meshes_of_ != frame->made) {
    view_.setGarment({garment, frame->made->input.garment.triangles});
    meshes_of_ = frame->made;
  }
  view_.moveGarment(garment);
  if (!shows_rest && frame->body.rows() > 0) view_.moveBody(frame->body);
  view_.showBody(body_is_shown_ && !shows_rest && frame->body.rows() > 0);
}

void ViewWidget::updateMarks() {
  Marks marks;
  if (content_ == Content::simulated) {
    addPartMarks(studio_, selected_ ? &*selected_ : nullptr, marks);
    if (sheet_) addPatternMarks(*sheet_, pick_, studio_.stage, marks);
    if (tool_) tool_->addMarks(marks);
  }
  const LiveFrame* frame = frameShown();
  if (marks.cloth_colors.empty() && frame && studio_.stage.hasCloth()) marks.cloth_colors = frameColors(shown_, *frame);
  view_.colorGarment(marks.cloth_colors);
  view_.colorBody(marks.body_colors);
  view_.setMarks(marks.lines, marks.dots);
}

QImage ViewWidget::drawn3d(const PictureSize& size) {
  const Picture& picture = view_.draw(studio_.stage.camera, size);
  const QImage image(picture.pixels.data(), size.width, size.height, 4 * size.width, QImage::Format_RGBX8888);
  return image.mirrored();
}

void ViewWidget::drawBar(QPainter& painter, const QRect& area) const {
  if (hasScale(shown_) && studio_.stage.hasCloth()) drawColorBar(painter, area, scaleOf(shown_, studio_.scene()));
}

void ViewWidget::paintEvent(QPaintEvent*) {
  if (is_stale_) {
    draw_s_ = 0.0;
    const Stopwatch stopwatch(draw_s_);
    if (content_ == Content::simulated) studio_.stage.size = pictureSize();
    update3d();
    updateMarks();
    image_ = drawn3d(pictureSize());
    image_.setDevicePixelRatio(devicePixelRatioF());
    is_stale_ = false;
    ++drawn_;
  }
  QPainter painter(this);
  painter.drawImage(0, 0, image_);
  drawBar(painter, rect());
}

QImage ViewWidget::picture(int times) {
  PictureSize size = pictureSize();
  size.width *= times;
  size.height *= times;
  update3d();
  updateMarks();
  QImage image = drawn3d(size);
  image.setDevicePixelRatio(times);
  QPainter painter(&image);
  drawBar(painter, QRect(0, 0, size.width / times, size.height / times));
  painter.end();
  image.setDevicePixelRatio(1.0);
  refresh();
  return image;
}

QImage ViewWidget::poseImage(int pose) {
  const PictureSize size{96, 112};
  const Positions& body = studio_.bodyInput().poses[pose];
  Camera camera;
  camera.frame(body.colwise().minCoeff(), body.colwise().maxCoeff(), size);
  view_.setMarks({}, {});
  view_.setGarment({});
  meshes_of_.reset();
  view_.showBody(true);
  view_.colorBody({});
  view_.moveBody(body);
  const Picture& picture = view_.draw(camera, size);
  const QImage image(picture.pixels.data(), size.width, size.height, 4 * size.width, QImage::Format_RGBX8888);
  refresh();
  return image.mirrored();
}

QPoint ViewWidget::pixelOf(const Vec3& point) const {
  const Projected seen = studio_.stage.camera.project(point, pictureSize());
  const double ratio = devicePixelRatioF();
  return {static_cast<int>(std::lround(seen.x / ratio)), static_cast<int>(std::lround(seen.y / ratio))};
}

void ViewWidget::resizeEvent(QResizeEvent*) {
  if (content_ == Content::simulated) studio_.stage.size = pictureSize();
  refresh();
}

}  // namespace ease
