// What the programs share: options of their own, beside those of Google Benchmark, and the course of main().
#pragma once

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <string>

#include "bench/build_info.h"

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

/// Says of the repetition at hand that it has no result, and why.  Within the loop over `state`; not SkipWithError,
/// with which Google Benchmark stops where other repetitions of the case had none.  `seconds`: for its own statistics.
inline void tellNoResult(benchmark::State& state, const std::string& why, double seconds = 0.0) {
  state.SetIterationTime(seconds);
  state.counters["no_result"] = 1.0;
  state.SetLabel(why);
}

/// Runs what `register_all` registers, fewer and shorter ones with `--quick`; the exit code.  Errors name the program.
inline int runBenchmarks(int count, char** arguments, const std::string& program,
                         const std::function<void(bool quick)>& register_all) try {
  const bool quick = takeFlag(count, arguments, "quick");
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 1;
  describeBuild();
  register_all(quick);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}: {}\n", program, error.what());
  return 1;
}

}  // namespace ease
