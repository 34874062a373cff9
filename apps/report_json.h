// The text of report.json.
#pragma once

#include <string>

#include "apps/report.h"

namespace ease {

/// Everything that a run counted and measured, as JSON; null for what was not measured. Units are in the keys.
std::string reportJson(const Report& report, const Scene& scene);

}  // namespace ease
