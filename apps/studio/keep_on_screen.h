// Keeps a window on the screen.
#pragma once

#include <QScreen>
#include <QWidget>
#include <algorithm>

namespace ease {

/// Shrinks and moves a window that is shown until it lies on the screen with the frame around it.
inline void keepOnScreen(QWidget& window) {
  if (window.isMaximized() || window.isFullScreen()) return;
  const QRect room = window.screen()->availableGeometry();
  window.resize(window.size().boundedTo(room.size() - (window.frameGeometry().size() - window.size())));
  const QRect frame = window.frameGeometry();
  window.move(std::clamp(frame.left(), room.left(), std::max(room.left(), room.right() + 1 - frame.width())),
              std::clamp(frame.top(), room.top(), std::max(room.top(), room.bottom() + 1 - frame.height())));
}

}  // namespace ease
