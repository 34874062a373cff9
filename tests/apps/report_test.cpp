#include "apps/report.h"

#include <catch2/catch.hpp>

using namespace ease;
using Catch::Contains;

namespace {

/// Returns a report of 360 steps in 6 s with replays of 25 s; the penetration is 1 mm while adapting, 3 mm afterwards.
Report verifiedReport() {
  Report report;
  report.limit = 0.1;
  report.time_step_s = 0.0025;
  report.pose_names = {"t"};
  report.setup_s = 1.0;
  report.total_s = 31.0;
  report.run.steps = 360;
  report.run.times.total = 5.0;
  report.run.times.step = 4.0;
  report.run.penetration.vertices = 1e-3;
  report.after.penetration.edge_midpoints = 3e-3;
  report.verified = true;
  return report;
}

}  // namespace

TEST_CASE("the summary tells the time of the run from that of the rest") {
  const std::string text = summaryText(verifiedReport());
  CHECK_THAT(text, Contains("360 steps of 2.5 ms in 6.0 s: 60.0 steps/s with setup and output, 90.0 the time steps"));
  CHECK_THAT(text, Contains("31.0 s in all: 25.0 s more for reading the scene, replays, pictures and report"));
}

TEST_CASE("the summary tells how deep the adapted garment goes into the body, and how deep it went before") {
  Report report = verifiedReport();
  CHECK_THAT(summaryText(report),
             Contains("deepest in the body, adapted garment replayed: vertices 0.00 mm, edge midpoints 3.00 mm") &&
                 Contains("deepest in the body, while adapting: vertices 1.00 mm, edge midpoints 0.00 mm"));
  report.verified = false;
  report.limit = 0.0;
  CHECK_THAT(summaryText(report), Contains("deepest in the body: vertices 1.00 mm") && !Contains("replay"));
}

TEST_CASE("a garment that goes deep into the body is warned of, in its replay as in the run") {
  Report report = verifiedReport();
  CHECK(runWarnings(report) == std::vector<std::string>{"the adapted garment went 3.0 mm into the body, replayed"});
  report.run.penetration.centroids = 5e-3;
  CHECK(runWarnings(report).back() == "the garment went 5.0 mm into the body while it was adapted");
  report.verified = false;
  report.limit = 0.0;
  CHECK(runWarnings(report) == std::vector<std::string>{"the garment went 5.0 mm into the body"});
}
