// What a run comes to, in a sentence and a few figures, as HTML.
#pragma once

#include <string>

#include "apps/report.h"

namespace ease {

/// The verdict and the figures below it.
std::string verdictHtml(const Scene& scene, const Report& report);

/// A share as text: "0.06 %".
std::string percentText(double share);

}  // namespace ease
