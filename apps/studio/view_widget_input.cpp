// Mouse and keys in the view: they turn and move it, or go to the tool.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/studio/view_widget.h"

namespace ease {

namespace {

constexpr double kZoomPerStep = 0.88;  // distance, a step of the wheel

}  // namespace

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

void ViewWidget::tellPointedAt() {
  if (underMouse() && gesture_ == Gesture::none && content_ == Content::simulated)
    Q_EMIT pointedAt(wordsAt(pointerOf(last_, {})));
}

void ViewWidget::leaveEvent(QEvent*) {
  Q_EMIT pointedAt("");
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
