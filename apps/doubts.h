// Why the figures of a run cannot be trusted: the garment left the body, was never on it, slid along it, was thrown, or
// fell because nothing holds it.
#pragma once

#include <string>
#include <vector>

#include "adaption/pass_record.h"
#include "apps/report.h"
#include "apps/scene.h"

namespace ease {

/// What the doubts of a pass are judged by.
struct DoubtContext {
  std::vector<int> file_vertices;  // number in the garment's file of each vertex of the run
  double body_speed_m_s = 0.0;     // of the body's surface, at most
};

/// Doubts about one pass, a line each; none: the garment was on the body. Parts with less than 5 % of the garment's
/// area, such as a loose button, are no doubt about the rest.
std::vector<std::string> doubtsOf(const PassRecord& pass, const DoubtContext& context);

/// The small parts that left the body, a line each.
std::vector<std::string> lostParts(const PassRecord& pass, const DoubtContext& context);

/// Says that most time steps of the pass ended further from their solution than `tolerance`, the relative error that
/// [solver] asks for; empty if not.
std::string missedTolerance(const PassRecord& pass, double tolerance);

/// Doubts about a scene without a body: connected parts of the garment that no pin holds, in the file's numbering.
std::vector<std::string> unheldParts(const Scene& scene, const SceneInput& input);

/// Adds the doubts about a run, or about its replays, to the report, and warnings of them and of what fell off.
/// `given`: the scene's input in the numbering of its files; `numbering`: the run's. `body_motion`: of the body's
/// surface in a time step, at most, m.
void doubt(const Scene& scene, const SceneInput& given, const Numbering& numbering, double body_motion, Report& report);

}  // namespace ease
