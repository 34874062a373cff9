// Functions shared by the benchmark programs: options in addition to those of Google Benchmark, and the body of main().
#pragma once

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <string>

#include "bench/build_info.h"

namespace ease {

/// Removes `--name=value` from the arguments and returns the value, or `otherwise` if the option is absent.
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

/// Removes `--name` from the arguments; returns whether it was there.
inline bool takeFlag(int& count, char** arguments, const std::string& name) {
  for (int i = 1; i < count; ++i) {
    if (arguments[i] != "--" + name) continue;
    std::rotate(arguments + i, arguments + i + 1, arguments + count);
    --count;
    return true;
  }
  return false;
}

/// Marks the current repetition as one without a result, with the reason; to be called within the loop over `state`.
/// SkipWithError cannot be used for this, because Google Benchmark then stops if only some repetitions of a case have
/// no result.  `seconds`: time to report for this repetition.
inline void tellNoResult(benchmark::State& state, const std::string& why, double seconds = 0.0) {
  state.SetIterationTime(seconds);
  state.counters["no_result"] = 1.0;
  state.SetLabel(why);
}

/// Runs the benchmarks that `register_all` registers and returns the exit code.  `--quick` asks for fewer and shorter
/// ones.  Error messages begin with the name of the program.
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
