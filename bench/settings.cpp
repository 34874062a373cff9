#include "bench/settings.h"

namespace ease {

namespace {

std::optional<Acceleration> accelerationNamed(const std::string& method) {
  if (method == "pd-anderson") return Acceleration::anderson;
  if (method == "pd-chebyshev") return Acceleration::chebyshev;
  return {};
}

Setting settingOf(const std::string& method, double value) {
  Setting setting{method, "tolerance", value, {}, accelerationNamed(method)};
  if (setting.acceleration) {
    setting.knob = "iterations";
    setting.options.iterations = static_cast<int>(value);
    return setting;
  }
  setting.options.method = methodNamed(method);
  if (method == "newton") {
    setting.knob = "residual";
    setting.options.residual = value;
  } else if (method == "pd") {
    setting.knob = "iterations";
    setting.options.iterations = static_cast<int>(value);
  } else if (method == "bw1") {
    setting.knob = "none";
  } else {
    setting.options.tolerance = value;
  }
  return setting;
}

}  // namespace

const std::vector<std::string>& allMethods() {
  static const std::vector<std::string> methods = {"bw1", "newton", "pd", "pd-lbfgs", "auto"};
  return methods;
}

const std::vector<std::string>& acceleratedMethods() {
  static const std::vector<std::string> methods = {"pd-anderson", "pd-chebyshev"};
  return methods;
}

std::vector<Setting> settingsOf(const std::string& method, bool coarse) {
  std::vector<double> values = {0.3, 0.1, 0.03, 0.01, 3e-3, 1e-3, 1e-4, 1e-5, 1e-6};
  if (coarse) values = {0.3, 0.05, 0.01, 1e-3, 1e-5};
  if (method == "bw1") values = {1.0};
  if (method == "newton") values = {100.0, 10.0, 1.0, 0.1, 1e-2, 1e-3, 1e-5, 1e-7};
  if (method == "newton" && coarse) values = {10.0, 1.0, 0.01, 1e-5};
  if (method == "pd") values = {1, 3, 10, 30, 100, 300, 1000};
  if (method == "pd" && coarse) values = {1, 10, 100};
  if (accelerationNamed(method)) values = {2, 5, 10, 20, 40, 80};
  std::vector<Setting> settings;
  for (double value : values) settings.push_back(settingOf(method, value));
  return settings;
}

Setting defaultSettingOf(const std::string& method) {
  const MethodOptions defaults;
  if (method == "newton") return settingOf(method, defaults.residual);
  if (method == "pd") return settingOf(method, defaults.iterations);
  return settingOf(method, defaults.tolerance);
}

}  // namespace ease
