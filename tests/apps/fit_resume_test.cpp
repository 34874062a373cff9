// Tests of resumed runs, started as a user would.
#include "apps/resume.h"

#include <nlohmann/json.hpp>

#include "solver/io/mesh_io.h"
#include "tests/apps/command.h"

using namespace ease;
using Catch::Contains;
using Catch::StartsWith;

TEST_CASE("a fit that goes on after a pass gives what an unbroken one gives, to the last byte") {
  const TemporaryDirectory directory;
  const auto write = [&](const char* name, int passes) {
    directory.write(name,
                    "[body]\nbuiltin = 'mannequin'\nposes = ['t', 'a']\nseconds_per_pose = 0.1\n[garment]\n"
                    "builtin = 't-shirt'\nvertices = 400\n[[garment.pin]]\nloop = 'neck'\n"
                    "[adaption]\nlimit = 0.02\ntarget = 0\npasses = " +
                        std::to_string(passes) + "\n[output]\nevery = 2\n");
  };
  write("whole.toml", 3);
  write("half.toml", 2);  // as if the fit had been stopped there
  REQUIRE(runEase(directory, "run whole.toml -o whole").code == 0);
  REQUIRE(runEase(directory, "run half.toml -o half").code == 0);
  const std::string shorter = contentOf(directory.path / "half/rest_shape.obj");
  const Outcome outcome = runEase(directory, "run whole.toml --resume half");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const auto report = nlohmann::json::parse(contentOf(directory.path / "half/report.json"));
  REQUIRE(report["adaption"]["passes"].size() == 3);
  CHECK(report["adaption"]["mode"] == "passes");
  CHECK(report["resumed_after_passes"] == 2);
  CHECK_FALSE(report.contains("resumed_from_step"));
  CHECK(report["sigma_1"].contains("before"));
  const auto& passes = report["adaption"]["passes"];
  CHECK(passes[2]["share_over_limit"] < passes[0]["share_over_limit"]);
  CHECK(passes[2]["area_ratio"] > passes[0]["area_ratio"]);
  CHECK(report["rest_embedding"]["mean"] < 0.005);
  CHECK(report["rest_embedding"]["p99"] < 0.03);
  for (const char* file : {"rest_shape.obj", "rest_shape.vtp", "garment.pvd", "garment/garment_000002.vtp"}) {
    INFO(file);
    const std::string whole = contentOf(directory.path / "whole" / file);
    CHECK(whole.size() > 100);
    const bool same = whole == contentOf(directory.path / "half" / file);
    CHECK(same);
  }
  CHECK(shorter != contentOf(directory.path / "whole/rest_shape.obj"));
  CHECK_THAT(runEase(directory, "run whole.toml --resume half").out, StartsWith("nothing left to do"));
}
