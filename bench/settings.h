// The methods with the settings that trade their speed for accuracy: a curve of the charts each.
#pragma once

#include <string>
#include <vector>

#include "solver/step/time_step.h"

namespace ease {

struct Setting {
  std::string method;  // as in a scene
  std::string knob;    // the key of [solver] that is turned, or "none"
  double value;
  MethodOptions options;
};

/// All methods as a scene names them.
const std::vector<std::string>& allMethods();

/// From loose to tight; a few (`coarse`) or twice as many.
std::vector<Setting> settingsOf(const std::string& method, bool coarse);

/// The default of a method in a scene.
Setting defaultSettingOf(const std::string& method);

}  // namespace ease
