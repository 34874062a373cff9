// Settings of each method that trade speed for accuracy.  The settings of one method give one curve of the charts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/accelerated_pd.h"

namespace ease {

struct Setting {
  std::string method;  // name in a scene, or in accelerated_pd.h
  std::string knob;    // key of [solver] that is varied, or "none"
  double value;
  MethodOptions options;                     // options of a method that scenes can name
  std::optional<Acceleration> acceleration;  // another method, which also uses options.iterations
};

/// Returns the names of all methods that scenes can name.
const std::vector<std::string>& allMethods();

/// Returns the names of the methods that only the benchmarks have (accelerated_pd.h).
const std::vector<std::string>& acceleratedMethods();

/// Returns the settings of a method, from loose to tight; with `coarse` about half as many.
std::vector<Setting> settingsOf(const std::string& method, bool coarse);

/// Returns the default setting that a method has in a scene.
Setting defaultSettingOf(const std::string& method);

}  // namespace ease
