// The scale of the colours as a bar with numbers, drawn over a picture.
#pragma once

#include <QPainter>
#include <QRect>

#include "apps/studio/frame_colors.h"

namespace ease {

/// Draws the bar along the bottom of an area.
void drawColorBar(QPainter& painter, const QRect& area, const ShownScale& bar);

}  // namespace ease
