// fit.html of whole runs: what stands in it, and how a browser shows it where one is installed.
#include "apps/page/fit_page.h"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/apps/command.h"

using namespace ease;
using Catch::Matchers::Contains;

namespace {

constexpr const char* kFitted = R"(
name = "a<b"
[body]
builtin = "mannequin"
poses = ["t", "up"]
[garment]
builtin = "t-shirt"
vertices = 300
[[garment.pin]]
loop = "neck"
[adaption]
limit = 0.08
passes = 2
)";

int count(const std::string& text, const std::string& word) {
  int found = 0;
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("the page of a fit holds its pictures, tables, charts and scene, and asks for no other file") {
  const TemporaryDirectory directory;
  directory.write("fitted.toml", kFitted);
  const Outcome run = runEase(directory, "run fitted.toml -o there");
  REQUIRE(run.code == 0);
  const std::string page = contentOf(directory.path / "there/fit.html");
  CHECK_THAT(page, Contains("<h1>a&lt;b</h1>") && Contains("Pose t") && Contains("Pose up"));
  CHECK_THAT(page, Contains("front") && Contains("over the limit, but crumpled") && Contains("Tightest places") &&
                       Contains("triangles over the limit"));
  CHECK_THAT(page, Contains("builtin = &quot;t-shirt&quot;"));
  CHECK(count(page, "src=\"") == count(page, "src=\"data:image/"));
  CHECK_THAT(page, !Contains("href=") && !Contains(">nan") && !Contains(">inf"));
  CHECK(page.size() < 5'000'000);
  if (run.err.find("no picture") != std::string::npos) {
    WARN("pictures skipped: " << run.err);
    return;
  }
  CHECK(count(page, "<figure") >= 4 * (2 + 4 + 1) + 10);
  if (std::system("command -v chromium >/dev/null") != 0) {
    WARN("Chromium is not installed: the page was not opened");
    return;
  }
  const std::string file = (directory.path / "there/fit.html").string(), shown = (directory.path / "dom.html").string();
  REQUIRE(
      std::system(("chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr --virtual-time-budget=5000 "
                   "--dump-dom 'file://" +
                   file + "#moment=3' > " + shown + " 2> " + shown + ".log")
                      .c_str()) == 0);
  CHECK_THAT(contentOf(shown), Contains("data-moment=\"3\"") && Contains("data-empty-pictures=\"0\""));
  CHECK_THAT(contentOf(shown + ".log"), !Contains("CONSOLE"));
}

TEST_CASE("a run without body or limit has its page too") {
  const TemporaryDirectory directory;
  writeHangingCloth(directory, 6);
  REQUIRE(runEase(directory, "run hang.toml -o there").code == 0);
  CHECK_THAT(contentOf(directory.path / "there/fit.html"),
             Contains("simulated, not fitted") && Contains("largest stretch") && !Contains("but crumpled"));
}
