#include "apps/page/pattern_in_page.h"

#include <catch2/catch.hpp>

#include "tests/apps/command.h"

using namespace ease;

TEST_CASE("a pattern's pictures come into the page, in place of earlier ones") {
  const TemporaryDirectory directory;
  directory.write("pattern.png", "Man");
  showPatternInPage(directory.path, "4 pieces", {"a < b"});  // no page: nothing happens
  CHECK_FALSE(std::filesystem::exists(directory.path / "fit.html"));
  directory.write("fit.html", std::string("before") + kPatternBegins + kPatternEnds + "after");
  showPatternInPage(directory.path, "4 pieces", {"a < b"});
  const std::string page = contentOf(directory.path / "fit.html");
  CHECK_THAT(page, Catch::Matchers::StartsWith("before") && Catch::Matchers::EndsWith("after"));
  CHECK_THAT(page, Catch::Contains("data:image/png;base64,TWFu"));
  CHECK_THAT(page, Catch::Contains("<pre>4 pieces</pre>") && Catch::Contains("<li>a &lt; b</li>"));
  showPatternInPage(directory.path, "4 pieces", {"a < b"});
  CHECK(contentOf(directory.path / "fit.html") == page);
  directory.write("fit.html", "a page of something else");
  showPatternInPage(directory.path, "4 pieces", {"a < b"});
  CHECK(contentOf(directory.path / "fit.html") == "a page of something else");
}
