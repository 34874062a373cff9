// The view of an editor: body, cloth and marks, turned with the right mouse button, worked on with the left one.
#pragma once

#include <QImage>
#include <QWidget>
#include <optional>

#include "apps/studio/frame_colors.h"
#include "apps/studio/pattern_sheet.h"
#include "apps/studio/tool.h"
#include "viz/live_view.h"

namespace ease {

/// Which mouse buttons turn and move the view.
enum class Navigation { clo, blender, paraview };

class ViewWidget : public QWidget {
  Q_OBJECT

 public:
  /// What the garment is shown as: as it is simulated, its rest shape, or a state that was kept.
  enum class Content { simulated, rest, kept };

  ViewWidget(Studio& studio, Content content, QWidget* parent = nullptr);

  void setTool(Tool* tool);
  void setShown(Shown shown);
  Shown shown() const { return shown_; }
  void setNavigation(Navigation navigation) { navigation_ = navigation; }
  void setSelected(const std::optional<Part>& part);
  /// Lights on the garment what is picked in its pattern.
  void setPicked(std::shared_ptr<const PatternSheet> sheet, const SheetPick& pick);
  void setContent(Content content) { content_ = content; }
  void keep(const LiveFrame& frame) { kept_ = frame; }
  void showBody(bool is_shown);
  void showEdges(bool are_shown);

  /// The meshes on show may have changed.
  void refresh();
  /// Measures once more what is under the pointer.
  void tellPointedAt();
  /// The picture without its window, `times` as large, with the colour bar.
  QImage picture(int times = 1);
  /// A small picture of a body pose.
  QImage poseImage(int pose);
  /// Pixel (of this widget) at which a point, m, appears.
  QPoint pixelOf(const Vec3& point) const;
  double drawSeconds() const { return draw_s_; }
  long drawn() const { return drawn_; }

 Q_SIGNALS:
  void used();                           // the tool has done or said something
  void cameraChanged();                  // for the other view
  void pointedAt(const QString& words);  // what was measured under the pointer; empty: nothing

 protected:
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent*) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Gesture { none, tool, orbit, pan };
  Gesture gestureOf(const QMouseEvent& event) const;
  Pointer pointerOf(const QPointF& at, Qt::KeyboardModifiers keys) const;
  PictureSize pictureSize() const;
  const LiveFrame* frameShown() const;
  void update3d();
  void updateMarks();
  QImage drawn3d(const PictureSize& size);
  void drawBar(QPainter& painter, const QRect& area) const;
  void cameraMoved();
  QString wordsAt(const Pointer& pointer) const;

  Studio& studio_;
  Content content_;
  LiveView view_;
  Tool* tool_ = nullptr;
  Shown shown_ = Shown::stretch;
  Navigation navigation_ = Navigation::clo;
  std::optional<Part> selected_;
  std::shared_ptr<const PatternSheet> sheet_;
  SheetPick pick_;
  std::optional<LiveFrame> kept_;
  std::shared_ptr<const MadeGarment> meshes_of_;
  bool is_stale_ = true, body_is_shown_ = true;
  Gesture gesture_ = Gesture::none;
  QPointF last_;
  QImage image_;
  double draw_s_ = 0.0;
  long drawn_ = 0;
};

}  // namespace ease
