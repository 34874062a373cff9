#include "tests/golden/golden_scenes.h"

#include <catch2/catch.hpp>

#include "tests/places.h"

using namespace ease;

TEST_CASE("small scenes end where they ended before") {
  const std::filesystem::path directory = std::filesystem::path(kSourceDirectory) / "tests/golden";
  for (const GoldenCase& which : goldenCases()) {
    const KeptResult kept = readKept(directory / (which.name() + ".txt"));
    // Builds of one name differ too where they are made for another processor of that instruction set (2e-9 m, seen
    // once).
    const double bound = kept.build == buildName() ? 1e-8 : 1e-6;
    INFO(which.name() << ", kept by " << kept.build << ", run by " << buildName()
                      << "; meant to change? script/renew_golden \"REASON\"");
    CHECK(difference(runGolden(which), kept.result) < bound);
  }
}

TEST_CASE("rounding does not decide where the kept scenes end") {
  // Another compiler or instruction set rounds otherwise.  Its results can be told from wrong ones where a disturbance
  // of garment and body by a thousand times the rounding of their coordinates stays far below the bound of 1e-6 m.
  for (const GoldenCase& which : goldenCases()) {
    INFO(which.name());
    const double change = difference(runGolden(which), runGolden(which, 1e-13));
    CHECK(change > 0.0);
    CHECK(change < 3e-7);
  }
}

TEST_CASE("the kept scenes are worth keeping: cloth moves, is pressed, grows, and methods agree") {
  for (const char* method : {"newton", "auto"}) {
    const GoldenResult hung = runGolden({"hung", method}), pressed = runGolden({"pressed", method}),
                       let_out = runGolden({"let_out", method});
    CHECK((hung.positions - hung.rest_positions).rowwise().norm().maxCoeff() > 0.05);
    CHECK(pressed.positions.col(1).maxCoeff() > 0.02);
    CHECK((let_out.rest_positions.col(0).maxCoeff() - 0.085) > 0.002);
    CHECK(difference(hung, runGolden({"hung", "pd-lbfgs"})) < 1e-3);
    CHECK(difference(pressed, runGolden({"pressed", "pd-lbfgs"})) < 1e-3);
  }
}

TEST_CASE("a kept result is read back as it was written, and one that is no such file is named") {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "ease_golden_test.txt";
  Positions x(2, 3);
  x << 0.1, -2.0, 3e-7, 1.0 / 3.0, 5.0, -0.25;
  writeKept(file, {x, 2.0 * x});
  const KeptResult kept = readKept(file);
  CHECK(kept.build == buildName());
  CHECK(difference(kept.result, {x, 2.0 * x}) < 1e-12);
  CHECK(difference(kept.result, {x, x}) > 1.0);
  std::filesystem::remove(file);
  CHECK_THROWS_WITH(readKept(file), Catch::Contains("ease_golden_test.txt") && Catch::Contains("renew_golden"));
}
