#include "apps/report.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "adaption/fit.h"
#include "apps/run_inputs.h"
#include "solver/base/whole_file.h"

namespace ease {

namespace {

using Json = nlohmann::ordered_json;

/// Returns statistics of the stretch as JSON, with null for values that were not measured.  `limited`: whether there is
/// a limit; only then are there triangles over it to count.
Json statistics(const std::optional<StretchStatistics>& s, bool limited) {
  Json json = {{"max", s ? Json(s->max) : Json()}, {"p99", s ? Json(s->p99) : Json()}};
  if (limited) {
    json["share_over_limit"] = s ? Json(s->share_over_limit) : Json();
    json["taut_share_over_limit"] = s ? Json(s->taut_share_over_limit) : Json();
  }
  return json;
}

Json stretchRecord(const StretchRecord& record, const std::vector<std::string>& pose_names, bool limited) {
  Json json = statistics(record.moments > 0 ? std::optional(record.overall) : std::nullopt, limited);
  json["poses"] = Json::array();
  for (size_t p = 0; p < record.poses.size(); ++p) {
    Json pose = {{"pose", pose_names[p]}};
    pose.update(statistics(record.poses[p], limited));
    json["poses"].push_back(pose);
  }
  return json;
}

Json penetration(const Penetration& p) {
  return {{"vertices", 1e3 * p.vertices},
          {"centroids", 1e3 * p.centroids},
          {"edge_midpoints", 1e3 * p.edge_midpoints},
          {"triangles", 1e3 * p.triangles}};
}

double peakMemoryMB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

double deepest(const Penetration& p) {
  return std::max({p.vertices, p.edge_midpoints, p.centroids, p.triangles});
}

std::string depthLine(const char* when, const Penetration& p) {
  return fmt::format(
      "deepest in the body{}: vertices {:.2f} mm, edge midpoints {:.2f} mm, centroids {:.2f} mm, whole triangles "
      "{:.2f} mm\n",
      when, 1e3 * p.vertices, 1e3 * p.edge_midpoints, 1e3 * p.centroids, 1e3 * deepest(p));
}

Json onBody(const PassRecord& pass) {
  Json parts = Json::array();
  for (const PartPresence& part : pass.on_body)
    parts.push_back({{"vertices", part.vertices},
                     {"area_share", part.area_share},
                     {"nearest_m", part.nearest_m},
                     {"distance_at_end_m", part.last_m},
                     {"off_since_s", part.off_since_s ? Json(*part.off_since_s) : Json()},
                     {"slid_m", part.slid_m}});
  return parts;
}

double perSecond(int steps, double seconds) {
  return seconds > 0.0 ? steps / seconds : 0.0;
}

/// Returns the value if it was measured, otherwise null.
Json measuredIf(bool measured, const Json& value) {
  return measured ? value : Json();
}

Json adaptionOf(const Report& report, const Scene& scene) {
  if (!fitsInPasses(scene)) return {{"mode", "sequential"}};
  Json json = {{"mode", "passes"}, {"target", scene.adaption->fit.target}, {"passes", Json::array()}};
  const bool has_tolerance = scene.solver.method != Method::newton && scene.solver.method != Method::bw1;
  const std::span passes(report.fit.passes);
  for (size_t p = 0; p < passes.size(); ++p) {
    const FitPass& pass = passes[p];
    const StretchStatistics& stretch = pass.record.stretch.overall;
    const double tolerance = toleranceOfPass(passes.first(p), scene.solver.tolerance);
    json["passes"].push_back({{"share_over_limit", stretch.share_over_limit},
                              {"taut_share_over_limit", stretch.taut_share_over_limit},
                              {"max", stretch.max},
                              {"area_ratio", pass.area_ratio},
                              {"tolerance", measuredIf(has_tolerance, tolerance)},
                              {"wall_s", pass.record.times.total}});
  }
  if (!report.verified) return json;
  json["chosen_pass"] = report.fit.best + 1;
  json["check"] = {{"share_over_limit", report.fit_result.check.stretch.overall.share_over_limit},
                   {"wall_s", report.fit_result.check.times.total}};
  json["target_met"] = report.doubts.empty() ? Json(report.fit_result.target_met) : Json();
  json["reason"] = report.doubts.empty() ? report.fit_result.reason : report.doubts.front();
  return json;
}

Json toJson(const Report& report, const Scene& scene) {
  const PassRecord& run = report.run;
  Json json;
  json["scene"] = scene.name;
  json["scene_file"] = std::filesystem::absolute(scene.file).lexically_normal().string();
  json["inputs"] = report.inputs;
  json["version"] = EASE_VERSION;
  json["method"] = nameOf(scene.solver.method);
  json["vertices"] = report.vertices;
  json["triangles"] = report.triangles;
  json["poses"] = report.pose_names.size();
  if (report.resumed_from_step) json["resumed_from_step"] = *report.resumed_from_step;
  if (report.fit.resumed_after > 0) json["resumed_after_passes"] = report.fit.resumed_after;
  json["steps"] = run.steps;
  json["parts_of_time_step"] = run.substeps.time;
  json["parts_of_interpolation_step"] = run.substeps.interpolation;
  json["settle_steps"] = run.settle_steps;
  json["simulated_s"] = run.steps * report.time_step_s;
  json["wall_s"] = {{"total", report.total_s},
                    {"setup", report.setup_s},
                    {"run", run.times.total},
                    {"step", run.times.step},
                    {"interpolation", run.times.interpolation},
                    {"level_set", run.times.level_set},
                    {"adaption", run.times.adaption},
                    {"output", run.times.output}};
  const bool moved = run.steps > 0;
  json["fps"] = {{"simulation", measuredIf(moved, perSecond(run.steps, run.times.step))},
                 {"full", measuredIf(moved, perSecond(run.steps, report.setup_s + run.times.total))}};
  const bool limited = report.limit > 0.0;
  if (limited) json["sigma_1"]["limit"] = 1.0 + report.limit;
  json["sigma_1"]["run"] = stretchRecord(run.stretch, report.pose_names, limited);
  if (report.verified) {
    json["sigma_1"]["before"] = stretchRecord(report.before.stretch, report.pose_names, limited);
    json["sigma_1"]["after"] = stretchRecord(report.after.stretch, report.pose_names, limited);
  }
  if (scene.adaption) json["adaption"] = adaptionOf(report, scene);
  if (report.time_to_fit_s) json["time_to_fit_s"] = *report.time_to_fit_s;
  if (report.verified && fitsInPasses(scene))
    json["rest_embedding"] = {{"mean", report.fit_result.embedding.mean}, {"p99", report.fit_result.embedding.p99}};
  json["rest_growth"] = {
      {"max", report.growth.max}, {"p99", report.growth.p99}, {"area_ratio", report.growth.area_ratio}};
  Penetration deepest = run.penetration;
  for (const PassRecord* pass : {&report.before, &report.after}) {
    deepest.vertices = std::max(deepest.vertices, pass->penetration.vertices);
    deepest.edge_midpoints = std::max(deepest.edge_midpoints, pass->penetration.edge_midpoints);
    deepest.triangles = std::max(deepest.triangles, pass->penetration.triangles);
    deepest.centroids = std::max(deepest.centroids, pass->penetration.centroids);
  }
  json["penetration_mm"] = penetration(deepest);
  json["penetration_mm"]["run"] = measuredIf(moved, penetration(run.penetration));
  if (report.verified) {
    json["penetration_mm"]["before"] = penetration(report.before.penetration);
    json["penetration_mm"]["after"] = penetration(report.after.penetration);
  }
  json["final_speed_m_s"] = measuredIf(run.stretch.moments > 0, run.final_speed_m_s);
  json["fastest_vertex"] =
      measuredIf(run.stretch.moments > 0, {{"speed_m_s", run.fastest.speed_m_s}, {"time_s", run.fastest.time_s}});
  json["on_body"]["run"] = onBody(run);
  if (report.verified) {
    json["on_body"]["before"] = onBody(report.before);
    json["on_body"]["after"] = onBody(report.after);
  }
  const std::string& method = nameOf(scene.solver.method);
  Json solver = {{"time_step_s", report.time_step_s}};
  if (method == "auto" || method == "pd-lbfgs" || method == "pd") solver["tolerance"] = scene.solver.tolerance;
  if (method == "newton") solver["residual_m_s2"] = scene.solver.residual;
  if (method == "pd") solver["iterations"] = scene.solver.iterations;
  solver["projective_iterations"] = run.solver.projective_iterations;
  solver["newton_iterations"] = run.solver.newton_iterations;
  solver["handed_over_to_newton"] = run.solver.handed_over;
  solver["cg_iterations"] = run.solver.cg_iterations;
  solver["factorisations"] = run.solver.factorisations;
  solver["contact_rounds"] = run.solver.contact_rounds;
  solver["adaptions"] = run.adaptions;
  solver["contact_stiffness_N_m3"] = run.contact_stiffness;
  json["solver"] = solver;
  json["rescues"] = {{"step_halvings", run.solver.halvings},
                     {"time_steps_short_of_tolerance", run.solver.short_of_tolerance},
                     {"voxels_on_demand", run.voxels_on_demand},
                     {"triangles_fully_grown", run.fully_grown},
                     {"rest_edges_folded", report.folded_edges},
                     {"contacts_held_between_parts", run.contact.held},
                     {"contacts_recovery_limited", run.contact.limited}};
  json["level_set_MB"] = run.level_set_MB;
  json["peak_memory_MB"] = peakMemoryMB();
  json["doubts"] = report.doubts;
  json["warnings"] = report.warnings;
  json["interrupted"] = report.interrupted;
  if (!report.failure.empty()) json["failure"] = report.failure;
  return json;
}

/// The time of the whole command.  The steps of a fit that went on were made in part by commands before this one.
std::string totalText(const Report& report, double run_s) {
  const double rest_s = report.total_s - run_s;
  if (rest_s < 0.0) return fmt::format("{:.1f} s in this command, the rest in those before it", report.total_s);
  return fmt::format("{:.1f} s in all: {:.1f} s more for {}pictures and report", report.total_s, rest_s,
                     report.verified ? (report.fit.passes.empty() ? "replays, " : "check, ") : "");
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
  writeWholeFile(directory / "report.json", toJson(report, scene).dump(2) + "\n");
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
  for (const std::string& doubt : report.doubts) text += fmt::format("stretch says nothing: {}\n", doubt);
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
