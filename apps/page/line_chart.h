// A chart of lines over time as SVG, for a web page.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ease {

struct ChartLine {
  std::string name;
  std::string color;  // of CSS
  std::vector<std::pair<double, double>> points;
};

struct LineChart {
  std::string title, x_title;  // with units
  std::vector<ChartLine> lines;
  std::optional<double> limit;  // a line across
};

/// The chart as an <svg> element, 460 x 250 units, with ticks at round values; 0 is always in it. Values that are not
/// finite are left out.
std::string toSvg(const LineChart& chart);

}  // namespace ease
