// A sewing pattern as JSON: outlines and seams for other programs, and figures for the report of the run.
#pragma once

#include "apps/pattern_files.h"

namespace ease {

/// The text of pattern.json.
std::string patternJson(const Scene& scene, const MadePattern& made);

/// Puts the figures into the report of a run under "pattern"; makes a report of them alone where there is none.
void addToReport(const Scene& scene, const MadePattern& made, const std::filesystem::path& report);

}  // namespace ease
