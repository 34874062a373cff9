// What the simulation measured, as a table for people.
#pragma once

#include <QString>

#include "apps/studio/live_run.h"

namespace ease {

/// `steps_per_s`, `pictures_per_s`: how fast simulation and view are now.
QString reportText(const LiveFrame& frame, double steps_per_s, double pictures_per_s);

}  // namespace ease
