#include "apps/page/line_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "garment/pattern/svg_file.h"
#include "viz/color_scale.h"

namespace ease {

namespace {

constexpr double kWidth = 460, kHeight = 250, kLeft = 52, kRight = 12, kTop = 30, kBottom = 40;

struct Range {
  double low = 0.0, high = 1.0;
  double share(double value) const { return (value - low) / (high - low); }
};

bool isFinite(const std::pair<double, double>& point) {
  return std::isfinite(point.first) && std::isfinite(point.second);
}

Range rangeOf(const LineChart& chart, bool of_x) {
  Range range{0.0, 0.0};
  const auto take = [&](double value) {
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  };
  for (const ChartLine& line : chart.lines)
    for (const auto& point : line.points)
      if (isFinite(point)) take(of_x ? point.first : point.second);
  if (!of_x && chart.limit) take(*chart.limit);
  if (range.high <= range.low) range.high = range.low + 1.0;
  if (!of_x) range.high += 0.05 * (range.high - range.low);
  return range;
}

}  // namespace

std::string toSvg(const LineChart& chart) {
  const Range x = rangeOf(chart, true), y = rangeOf(chart, false);
  const auto at_x = [&](double value) { return kLeft + x.share(value) * (kWidth - kLeft - kRight); };
  const auto at_y = [&](double value) { return kHeight - kBottom - y.share(value) * (kHeight - kTop - kBottom); };
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n", kWidth, kHeight,
                                escaped(chart.title));
  svg += fmt::format("<text class=\"title\" x=\"{}\" y=\"16\">{}</text>\n", kLeft, escaped(chart.title));
  const double y_step = tickStep(y.high - y.low, 5), x_step = tickStep(x.high - x.low, 6);
  for (double value = std::ceil(y.low / y_step) * y_step; value <= y.high; value += y_step)
    svg +=
        fmt::format("<path class=\"grid\" d=\"M{} {:.1f}H{}\"/><text x=\"{}\" y=\"{:.1f}\" class=\"y\">{:.4g}</text>\n",
                    kLeft, at_y(value), kWidth - kRight, kLeft - 6, at_y(value) + 4, value);
  for (double value = 0.0; value <= x.high * (1.0 + 1e-9); value += x_step)
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" class=\"x\">{:.4g}</text>\n", at_x(value), kHeight - kBottom + 16,
                       value);
  svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" class=\"x\">{}</text>\n", 0.5 * (kLeft + kWidth - kRight),
                     kHeight - 6, escaped(chart.x_title));
  if (chart.limit)
    svg += fmt::format("<path class=\"limit\" d=\"M{} {:.1f}H{}\"/>\n", kLeft, at_y(*chart.limit), kWidth - kRight);
  double name_x = kWidth - kRight;
  for (auto line = chart.lines.rbegin(); line != chart.lines.rend(); ++line) {
    std::string path;
    for (const auto& point : line->points)
      if (isFinite(point))
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", at_x(point.first), at_y(point.second));
    if (path.empty()) continue;
    svg += fmt::format("<path class=\"line\" stroke=\"{}\" d=\"{}\"/>\n", line->color, path);
    svg += fmt::format("<text x=\"{:.0f}\" y=\"16\" text-anchor=\"end\" style=\"fill:{}\">{}</text>\n", name_x,
                       line->color, escaped(line->name));
    name_x -= 8.0 * static_cast<double>(line->name.size()) + 12.0;
  }
  return svg + "</svg>\n";
}

}  // namespace ease
