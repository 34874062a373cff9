// Options of a bench program's own, beside those of Google Benchmark.
#pragma once

#include <algorithm>
#include <string>

namespace ease {

/// Takes `--name=value` out of the arguments.
inline std::string takeOption(int& count, char** arguments, const std::string& name, const std::string& otherwise) {
  const std::string prefix = "--" + name + "=";
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    if (!argument.starts_with(prefix)) continue;
    std::rotate(arguments + i, arguments + i + 1, arguments + count);
    --count;
    return argument.substr(prefix.size());
  }
  return otherwise;
}

/// Takes `--name` out of the arguments; whether it was there.
inline bool takeFlag(int& count, char** arguments, const std::string& name) {
  for (int i = 1; i < count; ++i) {
    if (arguments[i] != "--" + name) continue;
    std::rotate(arguments + i, arguments + i + 1, arguments + count);
    --count;
    return true;
  }
  return false;
}

}  // namespace ease
