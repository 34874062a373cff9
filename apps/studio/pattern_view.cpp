#include "apps/studio/pattern_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace ease {

namespace {

constexpr double kNearPixels = 7.0;
constexpr double kMargin = 12.0;  // pixels
constexpr double kZoomPerStep = 1.15;

QColor colorOf(const Rgb& rgb) {
  return {rgb[0], rgb[1], rgb[2]};
}

QPolygonF polygon(const std::vector<PaperPoint>& points, const QTransform& to_pixels) {
  QPolygonF shape;
  for (const PaperPoint& point : points) shape << to_pixels.map(QPointF(point.x(), point.y()));
  return shape;
}

}  // namespace

PatternView::PatternView(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setMinimumSize(240, 240);
  setToolTip("Click a piece or a line: it lights up on the garment. The wheel zooms, the right button moves.");
}

void PatternView::setSheet(std::shared_ptr<const PatternSheet> sheet) {
  sheet_ = std::move(sheet);
  pick_ = under_ = {};
  fit();
}

void PatternView::setPick(const SheetPick& pick) {
  pick_ = pick;
  update();
}

void PatternView::fit() {
  to_pixels_ = {};
  if (sheet_) {
    const Bounds bounds = sheet_->bounds();
    const PaperPoint size = (bounds.upper - bounds.lower).cwiseMax(1.0);
    const double scale =
        std::max(1e-3, std::min((width() - 2 * kMargin) / size.x(), (height() - 2 * kMargin) / size.y()));
    to_pixels_.translate(width() / 2.0, height() / 2.0);
    to_pixels_.scale(scale, -scale);
    to_pixels_.translate(-(bounds.lower + bounds.upper).x() / 2, -(bounds.lower + bounds.upper).y() / 2);
  }
  update();
}

QPoint PatternView::pixelOf(const PaperPoint& point) const {
  return to_pixels_.map(QPointF(point.x(), point.y())).toPoint();
}

SheetPick PatternView::at(const QPointF& pixel) const {
  if (!sheet_) return {};
  const QPointF point = to_pixels_.inverted().map(pixel);
  return sheet_->at({point.x(), point.y()}, kNearPixels / std::abs(to_pixels_.m11()));
}

void PatternView::drawPiece(QPainter& painter, size_t number) const {
  const SheetPiece& piece = sheet_->pieces[number];
  const auto isLit = [&](const SheetPick& pick) { return pick.what == SheetPick::What::piece && pick.piece == number; };
  painter.setPen(QPen(QColor(60, 64, 68), 1.0));
  painter.setBrush(isLit(pick_)    ? colorOf(kHoverColor)
                   : isLit(under_) ? colorOf(kHoverColor).lighter(150)
                                   : colorOf(LiveView::kClothColor).lighter(135));
  painter.drawPolygon(polygon(piece.cut, to_pixels_));
  for (const SheetEdge& edge : piece.edges) {
    const auto isLine = [&](const SheetPick& pick) {
      return pick.what == SheetPick::What::line && pick.line == edge.name && pick.is_sewn == edge.is_sewn;
    };
    const QColor color = colorOf(isLine(pick_) ? kHoverColor : edge.is_sewn ? kSeamColor : kLoopColor);
    painter.setPen(QPen(color, isLine(pick_) ? 5.0 : isLine(under_) ? 4.0 : 2.0));
    painter.drawPolyline(polygon(edge.points, to_pixels_));
  }
  painter.setPen(QPen(QColor(60, 64, 68), 1.0));
  if (piece.grain.size() == 2) {  // from below to above, with arrows
    const QPointF from = pixelOf(piece.grain[0]), to = pixelOf(piece.grain[1]);
    painter.drawLine(from, to);
    for (const double side : {-3.0, 3.0}) {
      painter.drawLine(from, from + QPointF(side, -6.0));
      painter.drawLine(to, to + QPointF(side, 6.0));
    }
  }
  QString name = QString::fromStdString(piece.name);
  if (piece.numbers.size() > 1) name += QString::fromUtf8("\n2 ×, one mirrored");
  QPoint at = pixelOf(piece.name_at);
  if (piece.grain.size() == 2) at.setY(pixelOf(piece.grain[0]).y() + 3);  // below the arrow
  painter.drawText(QRect(at.x() - 200, at.y(), 400, 100), Qt::AlignHCenter | Qt::AlignTop, name);
}

void PatternView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::white);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!sheet_) {
    painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap,
                     "No pattern yet: File, Pattern makes one");
    return;
  }
  for (size_t k = 0; k < sheet_->pieces.size(); ++k) drawPiece(painter, k);
}

void PatternView::mousePressEvent(QMouseEvent* event) {
  last_ = event->localPos();
  if (event->button() != Qt::LeftButton || !sheet_) return;
  setPick(at(event->localPos()));
  Q_EMIT picked();
}

void PatternView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF way = event->localPos() - last_;
  last_ = event->localPos();
  if (event->buttons() & (Qt::RightButton | Qt::MiddleButton))
    to_pixels_ *= QTransform::fromTranslate(way.x(), way.y());
  else
    under_ = at(event->localPos());
  update();
}

void PatternView::leaveEvent(QEvent*) {
  under_ = {};
  update();
}

void PatternView::wheelEvent(QWheelEvent* event) {
  const double factor = std::pow(kZoomPerStep, event->angleDelta().y() / 120.0);
  const QPointF at = event->position();
  to_pixels_ *= QTransform::fromTranslate(-at.x(), -at.y()) * QTransform::fromScale(factor, factor) *
                QTransform::fromTranslate(at.x(), at.y());
  update();
}

}  // namespace ease
