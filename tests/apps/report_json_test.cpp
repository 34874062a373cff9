#include "apps/report_json.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace ease;

namespace {

nlohmann::json jsonOf(const Report& report) {
  Scene scene;
  scene.file = "scene.toml";
  return nlohmann::json::parse(reportJson(report, scene));
}

/// A report of 360 steps in 6 s, 1 mm deep in the body, without a replay.
Report runReport() {
  Report report;
  report.limit = 0.1;
  report.time_step_s = 0.0025;
  report.setup_s = 1.0;
  report.run.steps = 360;
  report.run.times.total = 5.0;
  report.run.times.step = 4.0;
  report.run.penetration.vertices = 1e-3;
  return report;
}

}  // namespace

TEST_CASE("report.json has rates and depths in the units of its keys") {
  const nlohmann::json json = jsonOf(runReport());
  CHECK(json["simulated_s"] == Approx(0.9));
  CHECK(json["fps"]["full"] == Approx(60.0));
  CHECK(json["fps"]["simulation"] == Approx(90.0));
  CHECK(json["penetration_mm"]["vertices"] == Approx(1.0));
  CHECK(json["sigma_1"]["limit"] == Approx(1.1));
}

TEST_CASE("report.json has the deepest penetration of all passes, and each of them") {
  Report report = runReport();
  report.verified = true;
  report.after.penetration.edge_midpoints = 3e-3;
  const nlohmann::json depth = jsonOf(report)["penetration_mm"];
  CHECK(depth["edge_midpoints"] == Approx(3.0));
  CHECK(depth["run"]["edge_midpoints"] == 0.0);
  CHECK(depth["after"]["edge_midpoints"] == Approx(3.0));
}

TEST_CASE("what was not measured is null in report.json, and a failure is told") {
  Report report = runReport();
  report.run.steps = 0;
  report.failure = "time step 1: it broke";
  const nlohmann::json json = jsonOf(report);
  CHECK(json["fps"]["full"].is_null());
  CHECK(json["sigma_1"]["run"]["max"].is_null());
  CHECK(json["failure"] == "time step 1: it broke");
  CHECK_FALSE(jsonOf(runReport()).contains("failure"));
}
