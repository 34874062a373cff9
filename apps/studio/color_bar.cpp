#include "apps/studio/color_bar.h"

#include <algorithm>

namespace ease {

void drawColorBar(QPainter& painter, const QRect& area, const ShownScale& bar) {
  const int unit = painter.fontMetrics().height();
  // Beside the feet of a person in the middle, unless its words need more.
  const int words = painter.fontMetrics().horizontalAdvance(QString::fromStdString(bar.label));
  const int room = std::max(words, area.width() / 2 - 7 * unit);
  const QRect box(area.left() + unit, area.bottom() - 2 * unit - unit / 2,
                  std::min({22 * unit, room, area.width() - 4 * unit}), unit / 2 + 3);
  painter.fillRect(box.adjusted(-unit / 2, -unit - 6, unit / 2 + unit, 2 * unit), QColor(255, 255, 255, 200));
  const auto xOf = [&](double value) {
    return box.left() +
           static_cast<int>(box.width() * (value - bar.scale.low()) / (bar.scale.high() - bar.scale.low()));
  };
  for (int x = 0; x < box.width(); ++x) {
    const Rgb c = bar.scale.color(bar.scale.low() + (bar.scale.high() - bar.scale.low()) * (x + 0.5) / box.width());
    painter.fillRect(box.left() + x, box.top(), 1, box.height(), QColor(c[0], c[1], c[2]));
  }
  painter.setPen(QColor(30, 34, 38));
  painter.drawText(box.left(), box.top() - 5, QString::fromStdString(bar.label));
  const auto number = [&](double value) {
    const QString text = QString::number(value, 'g', 4);
    const int half = painter.fontMetrics().horizontalAdvance(text) / 2;
    painter.drawText(std::max(box.left(), xOf(value) - half), box.bottom() + unit, text);
  };
  number(bar.scale.low());
  number(bar.scale.high());
  if (!bar.has_limit) return number((bar.scale.low() + bar.scale.high()) / 2);
  number(bar.scale.limit());
  painter.drawLine(xOf(bar.scale.limit()), box.top() - 3, xOf(bar.scale.limit()), box.bottom() + 3);
}

}  // namespace ease
