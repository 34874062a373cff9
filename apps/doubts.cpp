#include "apps/doubts.h"

#include <fmt/format.h>

#include <algorithm>

namespace ease {

namespace {

constexpr double kLargePart = 0.05;      // share of the garment's area: smaller parts are no doubt about the rest
constexpr double kFarthestSlide = 0.15;  // m, from the place on the body where a part began
constexpr double kThrownSpeed = 10.0;    // m/s: a free fall of 5 m
constexpr double kThrownOverBody = 4.0;  // times the speed of the body's surface

std::string nameOf(const PartPresence& part, size_t number, const PassRecord& pass, const DoubtContext& context) {
  if (pass.on_body.size() == 1) return "the garment";
  return fmt::format("part {} of the garment ({} vertices, vertex {} among them, {:.0f} % of its area)", number + 1,
                     part.vertices, context.file_vertices[part.vertex], 100.0 * part.area_share);
}

/// Why a part is in doubt; empty if it is not. The end of a pass decides, because cloth may bounce.
std::string absence(const PartPresence& part) {
  if (!part.off_since_s) return "";
  if (*part.off_since_s == 0.0)
    return fmt::format("was never on the body: {:.2g} m away at its nearest, {:.2g} m at the end", part.nearest_m,
                       part.last_m);
  return fmt::format("left the body at {:.3g} s and is {:.2g} m away from it at the end", *part.off_since_s,
                     part.last_m);
}

template <class Wanted>
std::vector<std::string> absences(const PassRecord& pass, const DoubtContext& context, const Wanted& wanted) {
  std::vector<std::string> lines;
  for (size_t p = 0; p < pass.on_body.size(); ++p) {
    const PartPresence& part = pass.on_body[p];
    if (!wanted(part) || absence(part).empty()) continue;
    lines.push_back(fmt::format("{} {}, the fastest vertex at {:.3g} m/s", nameOf(part, p, pass, context),
                                absence(part), pass.fastest.speed_m_s));
  }
  return lines;
}

}  // namespace

std::vector<std::string> doubtsOf(const PassRecord& pass, const DoubtContext& context) {
  std::vector<std::string> lines =
      absences(pass, context, [](const PartPresence& part) { return part.area_share >= kLargePart; });
  for (size_t p = 0; p < pass.on_body.size(); ++p) {
    const PartPresence& part = pass.on_body[p];
    if (part.area_share < kLargePart || part.off_since_s || part.slid_m < kFarthestSlide) continue;
    lines.push_back(fmt::format("{} slid along the body: on average it ends {:.2g} m from the place where it began",
                                nameOf(part, p, pass, context), part.slid_m));
  }
  const double fastest = pass.fastest.speed_m_s;
  if (!pass.on_body.empty() && lines.empty() &&
      fastest > std::max(kThrownSpeed, kThrownOverBody * context.body_speed_m_s))
    lines.push_back(
        fmt::format("vertex {} of the garment was thrown: {:.3g} m/s at {:.3g} s, while the body moves {:.3g} m/s "
                    "at most",
                    context.file_vertices[pass.fastest.vertex], fastest, pass.fastest.time_s, context.body_speed_m_s));
  return lines;
}

std::vector<std::string> lostParts(const PassRecord& pass, const DoubtContext& context) {
  return absences(pass, context, [](const PartPresence& part) { return part.area_share < kLargePart; });
}

std::string missedTolerance(const PassRecord& pass, double tolerance) {
  const long solves = static_cast<long>(pass.steps) * pass.substeps.time, missed = pass.solver.short_of_tolerance;
  if (2 * missed <= solves) return "";
  return fmt::format(
      "{} of {} time steps ended further from their solution than the tolerance of {}: more iterations, "
      "shorter steps or [solver] method = 'auto' come nearer",
      missed, solves, tolerance);
}

std::vector<std::string> unheldParts(const Scene& scene, const SceneInput& input) {
  if (scene.body || scene.solver.gravity.isZero()) return {};
  std::vector<double> areas(input.garment.triangles.rows());
  for (size_t t = 0; t < areas.size(); ++t)
    areas[t] = triangleArea(input.garment.positions, input.garment.triangles, static_cast<int>(t));
  const std::vector<int> part =
      connectedParts(input.garment.triangles, areas, static_cast<int>(input.garment.positions.rows()));
  std::vector<char> held(*std::max_element(part.begin(), part.end()) + 1, 0);
  for (const std::vector<int>& pin : input.pins)
    for (const int v : pin) held[part[v]] = 1;
  std::vector<std::string> lines;
  for (size_t p = 0; p < held.size(); ++p) {
    if (held[p]) continue;
    const auto vertex = std::find(part.begin(), part.end(), static_cast<int>(p)) - part.begin();
    lines.push_back(held.size() == 1
                        ? "no [[garment.pin]] and no [body] hold the garment: it falls without end"
                        : fmt::format("no [[garment.pin]] and no [body] hold part {} of the garment, vertex {} among "
                                      "its vertices: it falls without end",
                                      p + 1, vertex));
  }
  return lines;
}

void doubt(const Scene& scene, const SceneInput& given, const Numbering& numbering, double body_motion,
           Report& report) {
  DoubtContext context{numbering.vertices, body_motion / scene.solver.time_step};
  for (int& vertex : context.file_vertices) vertex = fileVertex(given, vertex);
  const PassRecord& last = report.verified ? report.after : report.run;
  report.doubts = doubtsOf(last, context);
  if (report.verified && report.doubts.empty())
    for (const std::string& line : doubtsOf(report.before, context))
      report.doubts.push_back(line + ", with the first rest shape");
  for (const std::string& unheld : unheldParts(scene, given))
    (scene.adaption ? report.doubts : report.warnings).push_back(unheld);
  for (const std::string& line : report.doubts)
    report.warnings.push_back(line + ": the figures of the stretch cannot be trusted");
  for (const std::string& lost : lostParts(last, context)) report.warnings.push_back(lost);
  if (const std::string line = missedTolerance(last, scene.solver.tolerance); !line.empty())
    report.warnings.push_back(line);
}

}  // namespace ease
