#include "garment/pattern/svg_file.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/programs.h"

using namespace ease;

TEST_CASE("text is escaped for a drawing and a web page") {
  CHECK(escaped("a<b> & \"c\"") == "a&lt;b&gt; &amp; &quot;c&quot;");
}

TEST_CASE("an SVG is valid XML in millimetres, and other programs draw it") {
  const Drawing sheet = drawSheet("a < b & c", {plainPiece("front (\"left\")")}, 1400.0);
  const std::string text = svgText(sheet);
  CHECK(text.find("mm\" height=\"") != std::string::npos);
  const TemporaryFile file("pattern.svg", text);
  if (hasProgram("xmllint")) CHECK(run("xmllint --noout " + file.path()).code == 0);
  if (!hasProgram("rsvg-convert")) {
    WARN("rsvg-convert is not installed");
    return;
  }
  const std::string png = file.path() + ".png";
  CHECK(run("rsvg-convert -o " + png + " " + file.path()).code == 0);
  CHECK(std::filesystem::file_size(png) > 1000);
  std::filesystem::remove(png);
}
