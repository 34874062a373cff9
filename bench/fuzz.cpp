// Robustness against damaged inputs: scenes, and meshes of every format (tests/fuzz).  Every input is read by a command
// in a process of its own.
//
//   fuzz [--quick] [--inputs=N] [options of Google Benchmark]
//
// N: damaged inputs of every kind.  Each case is one kind of input, with these counters:
//
//   tried      damaged inputs, except those that ask for a long job
//   done       commands with exit code 0
//   silent     commands with exit code 0 and no warning, although the damaged mesh has another size than the whole one
//   doubtful   commands with exit code 3: done, but the garment is not on the body
//   refused    commands with exit code 1
//   failed     commands with exit code 2
//   crashes    commands ended by a signal
//   hangs      commands still running after minutes
//   unclear    commands that did not print one clear line, or left incomplete files
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "bench/program.h"
#include "tests/fuzz/command_fuzz.h"

using namespace ease;

namespace {

void tryDamages(benchmark::State& state, const FuzzKind& kind, unsigned inputs) {
  for (auto _ : state) {
    const CommandFuzz fuzz(kind);
    if (const FuzzOutcome whole = fuzz.attempt(0); whole.end != End::done)
      return state.SkipWithError(("undamaged: " + whole.text).c_str());
    std::map<End, int> ends;
    for (unsigned seed = 1; seed <= inputs; ++seed) {
      const FuzzOutcome outcome = fuzz.attempt(seed);
      ++ends[outcome.end];
      if (outcome.isFault()) fmt::print(stderr, "{}, seed {}: {}\n", kind.name, seed, outcome.text);
    }
    state.counters["tried"] = static_cast<int>(inputs) - ends[End::not_tried];
    state.counters["done"] = ends[End::done];
    state.counters["silent"] = ends[End::silent];
    state.counters["doubtful"] = ends[End::doubtful];
    state.counters["refused"] = ends[End::wrong_input];
    state.counters["failed"] = ends[End::failed];
    state.counters["crashes"] = ends[End::crash];
    state.counters["hangs"] = ends[End::hang];
    state.counters["unclear"] = ends[End::unclear];
  }
}

/// `asked`: damaged inputs of every kind; 0: as many as are usual.
void registerAll(bool quick, unsigned asked) {
  for (const FuzzKind& kind : fuzzKinds()) {
    const bool is_scene = kind.damaged == "scene.toml";
    const unsigned inputs = asked > 0 ? asked : quick ? 20 : is_scene ? 600 : 200;
    std::string input = kind.name;
    std::replace(input.begin(), input.end(), ' ', '_');
    benchmark::RegisterBenchmark(("fuzz/input:" + input).c_str(),
                                 [kind, inputs](benchmark::State& state) { tryDamages(state, kind, inputs); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const unsigned asked = static_cast<unsigned>(std::max(0, std::atoi(takeOption(argc, argv, "inputs", "0").c_str())));
  return runBenchmarks(argc, argv, "fuzz", [asked](bool quick) { registerAll(quick, asked); });
}
