#include "apps/page/line_chart.h"

#include <catch2/catch.hpp>
#include <limits>

using namespace ease;
using Catch::Matchers::Contains;

TEST_CASE("a chart draws its lines from corner to corner, its limit and its words, and leaves out what is not finite") {
  const LineChart chart{"a < b",
                        "time, s",
                        {{"after", "#123456", {{0.0, 0.0}, {1.0, 4.0}, {2.0, 8.0}}},
                         {"empty", "#654321", {{0.0, std::numeric_limits<double>::quiet_NaN()}}}},
                        5.0};
  const std::string svg = toSvg(chart);
  CHECK_THAT(svg, Contains("a &lt; b") && Contains("time, s") && Contains("class=\"limit\"") && Contains(">after<"));
  CHECK_THAT(svg, Contains("d=\"M52.0 210.0L250.0 ") && Contains("L448.0 "));
  CHECK_THAT(svg, !Contains("nan") && !Contains(">empty<"));
}

TEST_CASE("a chart reaches down to negative values") {
  const std::string svg = toSvg({"stretch, %", "time, s", {{"run", "#123456", {{0.0, -25.0}, {1.0, 5.0}}}}, {}});
  CHECK_THAT(svg, Contains("d=\"M52.0 210.0L448.0 ") && Contains(">-20<"));
}
