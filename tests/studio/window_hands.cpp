#include "tests/studio/window_hands.h"

#include <QSettings>
#include <QtTest>

namespace ease {

WindowHands::WindowHands() {
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, directory_.path());
}

Vec3 WindowHands::onBody(const Vec3& point) const {
  const Stage& stage = window_->studio().stage;
  return placeOn(nearestPlace(point, stage.body(), stage.bodyTriangles()), stage.body(), stage.bodyTriangles());
}

Vec3 WindowHands::onCloth(const Vec3& point) const {
  const Stage& stage = window_->studio().stage;
  const Triangles& triangles = stage.clothAsMade().triangles;
  return placeOn(nearestPlace(point, stage.cloth(), triangles), stage.cloth(), triangles);
}

void WindowHands::wait() {
  QTRY_VERIFY_WITH_TIMEOUT(!window_->studio().isMaking(), 20000);
  QTest::qWait(60);
  if (!window_->studio().simulation().plays()) window_->studio().finishWork();
  window_->sync();
  QTest::qWait(30);
}

void WindowHands::click(const Vec3& shown, Qt::KeyboardModifiers keys) {
  const QPoint at = window_->view().pixelOf(shown);
  QVERIFY(window_->view().rect().contains(at));
  move(at);
  QTest::mouseClick(window_->windowHandle(), Qt::LeftButton, keys, inWindow(at));
}

/// As the window system tells of the pointer, so that the view gets its events as in use.
QPoint WindowHands::inWindow(QPoint at) const {
  return window_->view().mapTo(window_.get(), at);
}

void WindowHands::move(QPoint at) {
  QTest::mouseMove(window_->windowHandle(), inWindow(at));
}

void WindowHands::drag(Qt::MouseButton button, QPoint from, QPoint to, Qt::KeyboardModifiers keys) {
  move(from);
  QTest::mousePress(window_->windowHandle(), button, keys, inWindow(from));
  constexpr int kSteps = 8;
  for (int k = 1; k <= kSteps; ++k) move(from + (to - from) * k / kSteps);
  QTest::mouseRelease(window_->windowHandle(), button, keys, inWindow(to));
}

/// Turns the view by a drag with the right button.
void WindowHands::turn(double yaw_deg) {
  const double way = std::remainder(window_->studio().stage.camera.yaw_deg - yaw_deg, 360.0) / 0.4;
  const QPoint middle = window_->view().rect().center();
  drag(Qt::RightButton, middle, middle + QPoint(static_cast<int>(std::lround(way / 2)), 0));
  drag(Qt::RightButton, middle, middle + QPoint(static_cast<int>(std::lround(way / 2)), 0));
  QVERIFY(std::abs(std::remainder(window_->studio().stage.camera.yaw_deg - yaw_deg, 360.0)) < 1.5);
}

void WindowHands::key(Qt::Key key, Qt::KeyboardModifiers keys) {
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  window_->view().setFocus();
  QTest::keyClick(&window_->view(), key, keys);
}

void WindowHands::loop(const std::vector<Vec3>& front, const std::vector<Vec3>& behind) {
  turn(0);
  for (const Vec3& point : front) click(onBody(point));
  turn(180);
  for (const Vec3& point : behind) click(onBody(point));
  key(Qt::Key_Return);
  wait();
  QVERIFY2(!window_->studio().isRefusal(), window_->studio().words().c_str());
}

std::string WindowHands::loopNear(const Vec3& point) const {
  const Stage& stage = window_->studio().stage;
  std::string nearest;
  double least = 1e9;
  for (const NamedLoop& edge : stage.made().edges) {
    Vec3 middle = Vec3::Zero();
    for (const int v : edge.vertices) middle += stage.clothAsMade().positions.row(v).transpose();
    middle /= static_cast<double>(edge.vertices.size());
    if ((middle - point).norm() >= least) continue;
    least = (middle - point).norm();
    nearest = edge.name;
  }
  return nearest;
}

/// The point of a loop that is seen best.
Vec3 WindowHands::onLoop(const std::string& name) const {
  const Stage& stage = window_->studio().stage;
  Vec3 best = Vec3::Constant(-1e9);
  for (const NamedLoop& edge : stage.made().edges)
    if (edge.name == name)
      for (const int v : edge.vertices)
        if (Vec3(stage.cloth().row(v)).dot(stage.camera.towardsEye()) > best.dot(stage.camera.towardsEye()))
          best = stage.cloth().row(v);
  return best;
}

void WindowHands::keepPicture(const char* name) {
  const QByteArray folder = qgetenv("EASE_STUDIO_PICTURES");
  if (!folder.isEmpty()) QVERIFY(window_->grab().save(QString(folder) + "/" + name + ".png"));
}

long WindowHands::pixelsNear(const QImage& image, const Rgb& color, int within) const {
  long count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor pixel = image.pixelColor(x, y);
      if (std::abs(pixel.red() - color[0]) <= within && std::abs(pixel.green() - color[1]) <= within &&
          std::abs(pixel.blue() - color[2]) <= within)
        ++count;
    }
  return count;
}

}  // namespace ease
