#include "apps/report.h"

#include <fmt/format.h>

#include <algorithm>

#include "adaption/fit.h"
#include "apps/report_json.h"
#include "apps/run_inputs.h"
#include "solver/base/whole_file.h"

namespace ease {

namespace {

double deepest(const Penetration& p) {
  return std::max({p.vertices, p.edge_midpoints, p.centroids, p.triangles});
}

std::string depthLine(const char* when, const Penetration& p) {
  return fmt::format(
      "deepest in the body{}: vertices {:.2f} mm, edge midpoints {:.2f} mm, centroids {:.2f} mm, whole triangles "
      "{:.2f} mm\n",
      when, 1e3 * p.vertices, 1e3 * p.edge_midpoints, 1e3 * p.centroids, 1e3 * deepest(p));
}

/// The time of the whole command.  The steps of a fit that went on were made in part by commands before this one.
std::string totalText(const Report& report, double run_s) {
  const double rest_s = report.total_s - run_s;
  if (rest_s < 0.0) return fmt::format("{:.1f} s in this command, the rest in those before it", report.total_s);
  return fmt::format("{:.1f} s in all: {:.1f} s more for reading the scene, {}pictures and report", report.total_s,
                     rest_s, report.verified ? (report.fit.passes.empty() ? "replays, " : "check, ") : "");
}

}  // namespace

void describe(const Scene& scene, const SceneInput& input, const Cloth& cloth, Report& report) {
  report.vertices = cloth.vertexCount();
  report.triangles = cloth.triangleCount();
  report.time_step_s = scene.solver.time_step;
  report.limit = scene.adaption ? scene.adaption->limit : 0.0;
  report.pose_names = input.pose_names;
  report.inputs = runInputs(scene);
  report.warnings = input.warnings;
}

void recordFit(const Fit& fit, double wall_s, Report& report) {
  report.fit = fit.state();
  report.fit_result = fit.result();
  for (const FitPass& pass : fit.state().passes) report.run += pass.record;
  if (fit.result().reason.empty()) return;
  report.before = fit.state().passes.front().record;
  const PassRecord &chosen = fit.state().passes[fit.state().best].record, &check = fit.result().check;
  const StretchStatistics &in_check = check.stretch.overall, &in_pass = chosen.stretch.overall;
  const bool check_is_worse = in_check.share_over_limit != in_pass.share_over_limit
                                  ? in_check.share_over_limit > in_pass.share_over_limit
                                  : in_check.max >= in_pass.max;
  report.after = check_is_worse ? check : chosen;
  report.run.fully_grown = chosen.fully_grown;
  report.time_to_fit_s = wall_s;
  report.verified = true;
}

void writeReport(const Report& report, const Scene& scene, const std::filesystem::path& directory) {
  writeWholeFile(directory / "report.json", reportJson(report, scene));
}

std::vector<std::string> runWarnings(const Report& report) {
  constexpr double kMaxDepth = 2e-3;  // m: deeper penetration causes a warning
  std::vector<std::string> warnings;
  const auto warn = [&](const char* garment, const Penetration& depth, const char* when) {
    if (deepest(depth) > kMaxDepth)
      warnings.push_back(fmt::format("{} went {:.1f} mm into the body{}", garment, 1e3 * deepest(depth), when));
  };
  if (report.verified) warn("the adapted garment", report.after.penetration, ", replayed");
  warn("the garment", report.run.penetration, report.limit > 0.0 ? " while it was adapted" : "");
  if (report.run.fully_grown > 0)
    warnings.push_back(
        fmt::format("{} triangles are still over the limit at {:g} times their first length: a load stretches them, "
                    "not the body's shape; is the cloth too weak for its weight, or pinned too far apart?",
                    report.run.fully_grown, kMaxGrowth));
  return warnings;
}

std::string summaryText(const Report& report) {
  const PassRecord& run = report.run;
  const double run_s = report.setup_s + run.times.total;
  std::string text;
  if (run.steps > 0)
    text = fmt::format(
        "{} vertices, {} steps of {:.4g} ms in {:.1f} s: {:.1f} steps/s with setup and output, {:.1f} the time steps "
        "alone\n{}\n",
        report.vertices, run.steps, 1e3 * report.time_step_s, run_s, perSecond(run.steps, run_s),
        perSecond(run.steps, run.times.step), totalText(report, run_s));
  else
    text = fmt::format("{} vertices, no time step was left to do; {:.1f} s in all\n", report.vertices, report.total_s);
  for (const std::string& doubt : report.doubts) text += fmt::format("stretch not to be trusted: {}\n", doubt);
  if (report.verified) {
    const auto line = [&](const char* when, const StretchRecord& s) {
      text += fmt::format(
          "{}stretch {}: at most {:.3f}, 99 % below {:.3f}, over {:.3g}: {:.2f} % of the triangles, {:.2f} % taut\n",
          report.doubts.empty() ? "" : "unverified ", when, s.overall.max, s.overall.p99, 1.0 + report.limit,
          100.0 * s.overall.share_over_limit, 100.0 * s.overall.taut_share_over_limit);
    };
    line("before", report.before.stretch);
    line("after ", report.after.stretch);
  }
  if (report.verified && !report.fit.passes.empty() && report.doubts.empty())
    text += fmt::format("{} in {} pass{}, {:.1f} s: {}\n",
                        report.fit_result.target_met ? "fitted" : "the target was not met", report.fit.passes.size(),
                        report.fit.passes.size() == 1 ? "" : "es", report.time_to_fit_s.value_or(0.0),
                        report.fit_result.reason);
  if (report.limit > 0.0)
    text += fmt::format("rest shape: area {:+.2f} %, largest growth {:.2f} times, 99 % below {:.2f}\n",
                        100.0 * (report.growth.area_ratio - 1.0), report.growth.max, report.growth.p99);
  if (report.pose_names.empty()) return text;
  if (report.verified) text += depthLine(", adapted garment replayed", report.after.penetration);
  if (run.steps > 0) text += depthLine(report.limit > 0.0 ? ", while adapting" : "", run.penetration);
  return text;
}

}  // namespace ease
