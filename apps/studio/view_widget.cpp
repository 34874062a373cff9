#include "apps/studio/view_widget.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

#include "apps/studio/color_bar.h"
#include "solver/base/stopwatch.h"

namespace ease {

constexpr double kZoomPerStep = 0.88;  // distance, a step of the wheel

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

ViewWidget::Gesture ViewWidget::gestureOf(const QMouseEvent& event) const {
  const bool alt = event.modifiers() & Qt::AltModifier, shift = event.modifiers() & Qt::ShiftModifier;
  if (event.button() == Qt::LeftButton) {
    if (alt) return shift ? Gesture::pan : Gesture::orbit;
    const Pointer at = pointerOf(event.localPos(), {});
    if (navigation_ == Navigation::paraview && !studio_.stage.hitBody(at.x, at.y) &&
        !studio_.stage.hitCloth(at.x, at.y))
      return Gesture::orbit;
    return content_ == Content::simulated ? Gesture::tool : Gesture::orbit;
  }
  if (event.button() == Qt::MiddleButton)
    return navigation_ == Navigation::blender && !shift ? Gesture::orbit : Gesture::pan;
  return event.button() == Qt::RightButton ? Gesture::orbit : Gesture::none;
}

Pointer ViewWidget::pointerOf(const QPointF& at, Qt::KeyboardModifiers keys) const {
  const double ratio = devicePixelRatioF();
  return {at.x() * ratio, at.y() * ratio, bool(keys & Qt::ShiftModifier), bool(keys & Qt::ControlModifier)};
}

void ViewWidget::mousePressEvent(QMouseEvent* event) {
  if (gesture_ != Gesture::none) return;  // one button at a time
  gesture_ = gestureOf(*event);
  last_ = event->localPos();
  if (gesture_ != Gesture::tool) return;
  if (tool_)
    tool_->press(pointerOf(event->localPos(), event->modifiers()));
  else
    studio_.say("choose a tool: keys 1 to 7");
  refresh();
  Q_EMIT used();
}

void ViewWidget::cameraMoved() {
  refresh();
  Q_EMIT cameraChanged();
}

QString ViewWidget::wordsAt(const Pointer& pointer) const {
  const LiveFrame* frame = studio_.frame();
  if (!frame || !studio_.stage.hasCloth()) return {};
  const std::optional<Hit> hit = studio_.stage.hitCloth(pointer.x, pointer.y);
  return hit ? QString::fromStdString(wordsOf(*frame, hit->place.triangle)) : QString();
}

void ViewWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF way = event->localPos() - last_;
  last_ = event->localPos();
  const Pointer pointer = pointerOf(event->localPos(), event->modifiers());
  const double ratio = devicePixelRatioF();
  if (gesture_ == Gesture::orbit) {
    studio_.stage.camera.orbit(way.x(), way.y());
    return cameraMoved();
  }
  if (gesture_ == Gesture::pan) {
    studio_.stage.camera.pan(way.x() * ratio, way.y() * ratio, pictureSize());
    return cameraMoved();
  }
  if (!tool_ || content_ != Content::simulated) return;
  if (gesture_ == Gesture::none) Q_EMIT pointedAt(wordsAt(pointer));
  if (gesture_ == Gesture::tool) {
    tool_->drag(pointer);
    Q_EMIT used();
  } else {
    tool_->hover(pointer);
  }
  refresh();
}

void ViewWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (std::exchange(gesture_, Gesture::none) != Gesture::tool || !tool_) return;
  tool_->release(pointerOf(event->localPos(), event->modifiers()));
  refresh();
  Q_EMIT used();
}

void ViewWidget::wheelEvent(QWheelEvent* event) {
  const double steps = event->angleDelta().y() / 120.0;
  ToolSettings& set = studio_.settings;
  if (event->modifiers() & Qt::ControlModifier) {
    set.radius = std::clamp(set.radius * std::pow(1.1, steps), 0.005, 1.0);
    Q_EMIT used();
    return refresh();
  }
  if (event->modifiers() & Qt::ShiftModifier) {
    set.scale = std::clamp(set.scale + 0.01 * steps, 1.01, 2.0);
    set.offset = std::clamp(set.offset + 0.001 * steps, 0.0, 0.1);
    Q_EMIT used();
    return refresh();
  }
  const Pointer pointer = pointerOf(event->position(), event->modifiers());
  studio_.stage.camera.zoom(std::pow(kZoomPerStep, steps), pointer.x, pointer.y, pictureSize());
  cameraMoved();
}

void ViewWidget::leaveEvent(QEvent*) {
  if (gesture_ != Gesture::none || !tool_ || content_ != Content::simulated) return;
  tool_->hover({-1e6, -1e6});
  refresh();
}

void ViewWidget::keyPressEvent(QKeyEvent* event) {
  if (!tool_) return QWidget::keyPressEvent(event);
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      tool_->finish();
      break;
    case Qt::Key_Backspace:
      tool_->back();
      break;
    case Qt::Key_Escape:
      tool_->cancel();
      break;
    case Qt::Key_Delete:
      tool_->remove();
      break;
    default:
      return QWidget::keyPressEvent(event);
  }
  refresh();
  Q_EMIT used();
}

}  // namespace ease
