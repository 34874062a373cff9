// The pieces of the sewing pattern in the plane: outlines, lines to sew, grain and names.  A click picks a piece or a
// line; the wheel zooms, the right or middle button moves.
#pragma once

#include <QTransform>
#include <QWidget>
#include <memory>

#include "apps/studio/pattern_sheet.h"

namespace ease {

class PatternView : public QWidget {
  Q_OBJECT

 public:
  explicit PatternView(QWidget* parent = nullptr);

  void setSheet(std::shared_ptr<const PatternSheet> sheet);
  const std::shared_ptr<const PatternSheet>& sheet() const { return sheet_; }
  void setPick(const SheetPick& pick);
  const SheetPick& pick() const { return pick_; }
  /// Pixel of this widget at which a point of the sheet, mm, appears.
  QPoint pixelOf(const PaperPoint& point) const;

 Q_SIGNALS:
  void picked();

 protected:
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override { fit(); }
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent*) override;
  void wheelEvent(QWheelEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent*) override { fit(); }

 private:
  void fit();
  SheetPick at(const QPointF& pixel) const;
  void drawPiece(QPainter& painter, size_t number) const;

  std::shared_ptr<const PatternSheet> sheet_;
  SheetPick pick_, under_;
  QTransform to_pixels_;  // from mm on the sheet
  QPointF last_;
};

}  // namespace ease
