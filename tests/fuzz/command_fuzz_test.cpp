// The program on damaged files: it ends by itself with 0, 1 or 2, says why in one line and leaves nothing half written.
//
// EASE_FUZZ_ROUNDS=1000 tries that many of every kind.
#include "tests/fuzz/command_fuzz.h"

#include <catch2/catch.hpp>
#include <cstdlib>

using namespace ease;

namespace {

int rounds(int usual) {
  const char* asked = std::getenv("EASE_FUZZ_ROUNDS");
  return asked ? std::atoi(asked) : usual;
}

/// Whether the thread sanitizer watches, which cannot follow a fork whose child starts threads: commands are then tried
/// as programs of their own alone.
bool cannotFork() {
#ifdef __SANITIZE_THREAD__
  WARN("skipped under the thread sanitizer");
  return true;
#else
  return false;
#endif
}

/// Damages of the seeds from `first` on; how many of them were refused.
int refusedOf(const FuzzKind& kind, unsigned first, int count, const std::string& program = "") {
  const CommandFuzz fuzz(kind, program);
  const FuzzOutcome whole = fuzz.attempt(0);
  INFO(kind.name << ": " << whole.text);
  CHECK(whole.end == End::done);
  int refused = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    const FuzzOutcome outcome = fuzz.attempt(seed);
    INFO(kind.name << ", seed " << seed << ": " << outcome.text);
    CHECK_FALSE(outcome.isFault());
    refused += outcome.end == End::wrong_input ? 1 : 0;
  }
  return refused;
}

}  // namespace

TEST_CASE("a command on a damaged scene ends in order") {
  if (cannotFork()) return;
  for (const FuzzKind& kind : fuzzKinds())
    if (kind.damaged == "scene.toml") CHECK(refusedOf(kind, 1, rounds(40)) > 0);
}

TEST_CASE("a command on a damaged mesh ends in order, whatever its format") {
  if (cannotFork()) return;
  for (const FuzzKind& kind : fuzzKinds())
    if (kind.damaged != "scene.toml") CHECK(refusedOf(kind, 1, rounds(12)) > 0);
}

TEST_CASE("the program itself ends in order on damaged files") {
  for (const FuzzKind& kind : fuzzKinds()) refusedOf(kind, 1001, rounds(4), EASE_COMMAND);
}
