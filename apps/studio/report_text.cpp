#include "apps/studio/report_text.h"

namespace ease {

namespace {

QString row(const QString& name, const QString& value) {
  return "<tr><td>" + name + "&nbsp;&nbsp;</td><td align=right>" + value + "</td></tr>";
}

QString number(double x, int decimals) {
  return QString::number(x, 'f', decimals);
}

}  // namespace

QString reportText(const LiveFrame& frame, double steps_per_s, double pictures_per_s) {
  const std::optional<AdaptionScene>& adaption = frame.made->scene.adaption;
  QString text = "<table cellspacing=0>";
  text += row("Vertices", QString::number(frame.garment.rows()));
  text += row("Simulated time", number(frame.time_s, 2) + " s");
  text += row("Steps, pictures", number(steps_per_s, 0) + ", " + number(pictures_per_s, 0) + " /s");
  text += row("Stretch, largest", number(frame.statistics.max, 3));
  text += row("Stretch, 99 % below", number(frame.statistics.p99, 3));
  if (adaption)
    text +=
        row("Over " + number(1.0 + adaption->limit, 2), number(100.0 * frame.statistics.share_over_limit, 2) + " %");
  text += row("Deepest in the body", number(1000.0 * frame.deepest, 1) + " mm");
  text += row("Cloth let out", number(100.0 * frame.let_out, 2) + " %");
  return text + "</table>";
}

}  // namespace ease
