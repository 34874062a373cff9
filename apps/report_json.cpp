#include "apps/report_json.h"

#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "adaption/fit.h"

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

Json solverJson(const Report& report, const Scene& scene) {
  const PassRecord& run = report.run;
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
  return solver;
}

Json rescuesJson(const Report& report) {
  const PassRecord& run = report.run;
  return {{"step_halvings", run.solver.halvings},
          {"time_steps_short_of_tolerance", run.solver.short_of_tolerance},
          {"voxels_on_demand", run.voxels_on_demand},
          {"triangles_fully_grown", run.fully_grown},
          {"rest_edges_folded", report.folded_edges},
          {"contacts_held_between_parts", run.contact.held},
          {"contacts_recovery_limited", run.contact.limited},
          {"contact_planes_kept", run.solver.kept_planes}};
}

/// Largest penetration of all passes, and that of each, mm.
Json penetrationJson(const Report& report) {
  Penetration deepest = report.run.penetration;
  for (const PassRecord* pass : {&report.before, &report.after}) {
    deepest.vertices = std::max(deepest.vertices, pass->penetration.vertices);
    deepest.edge_midpoints = std::max(deepest.edge_midpoints, pass->penetration.edge_midpoints);
    deepest.triangles = std::max(deepest.triangles, pass->penetration.triangles);
    deepest.centroids = std::max(deepest.centroids, pass->penetration.centroids);
  }
  Json json = penetration(deepest);
  json["run"] = measuredIf(report.run.steps > 0, penetration(report.run.penetration));
  if (report.verified) {
    json["before"] = penetration(report.before.penetration);
    json["after"] = penetration(report.after.penetration);
  }
  return json;
}

/// What was computed, how much and how fast.
void addWork(const Report& report, const Scene& scene, Json& json) {
  const PassRecord& run = report.run;
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
}

}  // namespace

std::string reportJson(const Report& report, const Scene& scene) {
  const PassRecord& run = report.run;
  Json json;
  addWork(report, scene, json);
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
  json["penetration_mm"] = penetrationJson(report);
  json["final_speed_m_s"] = measuredIf(run.stretch.moments > 0, run.final_speed_m_s);
  json["fastest_vertex"] =
      measuredIf(run.stretch.moments > 0, {{"speed_m_s", run.fastest.speed_m_s}, {"time_s", run.fastest.time_s}});
  json["on_body"]["run"] = onBody(run);
  if (report.verified) {
    json["on_body"]["before"] = onBody(report.before);
    json["on_body"]["after"] = onBody(report.after);
  }
  json["solver"] = solverJson(report, scene);
  json["rescues"] = rescuesJson(report);
  json["level_set_MB"] = run.level_set_MB;
  json["peak_memory_MB"] = peakMemoryMB();
  json["doubts"] = report.doubts;
  json["warnings"] = report.warnings;
  json["interrupted"] = report.interrupted;
  if (!report.failure.empty()) json["failure"] = report.failure;
  return json.dump(2) + "\n";
}

}  // namespace ease
