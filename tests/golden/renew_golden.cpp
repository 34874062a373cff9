// Runs the kept scenes and writes their results anew: renew_golden DIRECTORY.  Prints a line for each that changed by
// more than rounding: by how much, m.  Called by script/renew_golden.
#include <fmt/format.h>

#include <exception>

#include "tests/golden/golden_scenes.h"

namespace {

void renew(const std::filesystem::path& directory) {
  for (const ease::GoldenCase& which : ease::goldenCases()) {
    const std::filesystem::path file = directory / (which.name() + ".txt");
    const ease::GoldenResult result = ease::runGolden(which);
    if (!std::filesystem::exists(file)) {
      fmt::print("- {}: new\n", which.name());
    } else {
      const ease::KeptResult kept = ease::readKept(file);
      const double change = ease::difference(kept.result, result);
      if (change < 1e-9 && kept.build == ease::buildName()) continue;
      fmt::print("- {}: {:.2g} m\n", which.name(), change);
    }
    ease::writeKept(file, result);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    fmt::print(stderr, "usage: renew_golden DIRECTORY\n");
    return 1;
  }
  try {
    renew(arguments[1]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "renew_golden: error: {}\n", error.what());
    return 2;
  }
  return 0;
}
