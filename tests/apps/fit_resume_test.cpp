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

TEST_CASE("a fit that is over goes on where its scene has changed, and begins anew with other paint") {
  const TemporaryDirectory directory;
  const auto resume = [&](const std::string& limit, const std::string& paint, const std::string& arguments) {
    directory.write("fit.toml",
                    "[body]\nbuiltin = 'mannequin'\nposes = ['t', 'a']\nseconds_per_pose = 0.1\n[garment]\n"
                    "builtin = 't-shirt'\nvertices = 400\n[[garment.pin]]\nloop = 'neck'\n" +
                        paint + "[adaption]\npasses = 4\nlimit = " + limit + "\n");
    const Outcome outcome = runEase(directory, "run fit.toml " + arguments);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return nlohmann::json::parse(contentOf(directory.path / "there/report.json"));
  };
  const auto passes = [](const nlohmann::json& report) { return report["adaption"]["passes"].size(); };
  const auto lax = resume("0.5", "", "-o there");
  CHECK(passes(lax) == 1);
  CHECK(lax["rest_growth"]["max"] == Approx(1.0));
  const auto strict = resume("0.02", "", "--resume there");
  CHECK(strict["resumed_after_passes"] == 1);
  CHECK(strict["adaption"]["chosen_pass"] > 1);  // what the lax limit allowed does not count
  CHECK(passes(strict) > 1);
  CHECK(strict["rest_growth"]["max"] > 1.01);
  const auto painted =
      resume("0.02", "[[garment.paint]]\nat = [0, 1.2, 0.1]\nradius = 0.3\nscale = 1.2\n", "--resume there");
  CHECK_FALSE(painted.contains("resumed_after_passes"));
  const auto whole = resume("0.02", "[[garment.paint]]\nat = [0, 1.2, 0.1]\nradius = 0.3\nscale = 1.2\n", "-o there");
  CHECK(painted["adaption"]["passes"][0]["share_over_limit"] == whole["adaption"]["passes"][0]["share_over_limit"]);
  CHECK(painted["rest_growth"]["area_ratio"] == whole["rest_growth"]["area_ratio"]);
}
