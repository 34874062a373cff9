// The methods with the settings that trade their speed for accuracy: a curve of the charts each.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/accelerated_pd.h"

namespace ease {

struct Setting {
  std::string method;  // as in a scene, or of the bench alone
  std::string knob;    // the key of [solver] that is turned, or "none"
  double value;
  MethodOptions options;                     // of a method as in a scene
  std::optional<Acceleration> acceleration;  // of another, with options.iterations
};

/// All methods as a scene names them.
const std::vector<std::string>& allMethods();

/// Methods of the bench alone (accelerated_pd.h).
const std::vector<std::string>& acceleratedMethods();

/// From loose to tight; a few (`coarse`) or twice as many.
std::vector<Setting> settingsOf(const std::string& method, bool coarse);

/// The default of a method in a scene.
Setting defaultSettingOf(const std::string& method);

}  // namespace ease
