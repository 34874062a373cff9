// Hands for the editor's window: mouse and keys as the window system tells of them, at points given in metres.
#pragma once

#include <QTemporaryDir>
#include <memory>

#include "apps/studio/main_window.h"

namespace ease {

class WindowHands : public QObject {
 public:
  WindowHands();  // keeps the settings of who runs the tests out of them

 protected:
  Vec3 onBody(const Vec3& point) const;
  Vec3 onCloth(const Vec3& point) const;
  void click(const Vec3& shown, Qt::KeyboardModifiers keys = {});
  QPoint inWindow(QPoint at) const;
  void move(QPoint at);
  void drag(Qt::MouseButton button, QPoint from, QPoint to, Qt::KeyboardModifiers keys = {});
  void turn(double yaw_deg);
  void key(Qt::Key key, Qt::KeyboardModifiers keys = {});
  void wait();
  void loop(const std::vector<Vec3>& front, const std::vector<Vec3>& behind);
  Vec3 onLoop(const std::string& name) const;
  std::string loopNear(const Vec3& point) const;
  void keepPicture(const char* name);
  long pixelsNear(const QImage& image, const Rgb& color, int within) const;
  const GarmentScene& garment() const { return window_->studio().scene().garment; }

  QTemporaryDir directory_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace ease
