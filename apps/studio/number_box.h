// A number field that leaves the window's keys and the wheel alone.
#pragma once

#include <QDoubleSpinBox>

namespace ease {

/// The wheel changes it only where it has been clicked into, so that scrolling past changes nothing. Keys that no
/// number is written with, such as Space and Ctrl+Z, do what they do elsewhere in the window. A click on an arrow does
/// not keep the keys.
class NumberBox : public QDoubleSpinBox {
 public:
  NumberBox();

 protected:
  bool event(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
};

}  // namespace ease
