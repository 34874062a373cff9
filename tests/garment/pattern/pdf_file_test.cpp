#include "garment/pattern/pdf_file.h"

#include <catch2/catch.hpp>

#include <fmt/format.h>

#include "tests/garment/pattern/programs.h"

using namespace ease;

TEST_CASE("a PDF of one sheet has the sheet's size") {
  const Drawing sheet = drawSheet("pattern", {plainPiece("front"), plainPiece("b\\ack)")}, 1400.0);
  const TemporaryFile file("pattern.pdf", pdfText(sheet, {wholePage(sheet)}));
  if (!hasProgram("pdfinfo")) {
    WARN("pdfinfo is not installed");
    return;
  }
  const Ran info = run("pdfinfo " + file.path());
  CHECK(info.code == 0);
  CHECK(info.output.find("Error") == std::string::npos);
  CHECK(info.output.find("Pages:           1\n") != std::string::npos);
  double width = 0.0, height = 0.0;
  REQUIRE(std::sscanf(info.output.c_str() + info.output.find("Page size:"), "Page size: %lf x %lf", &width, &height) ==
          2);
  CHECK(width * 25.4 / 72.0 == Approx(sheet.width).margin(0.01));
  CHECK(height * 25.4 / 72.0 == Approx(sheet.height).margin(0.01));
}

TEST_CASE("a sheet longer than 14400 points has larger units, not another size") {
  Drawing sheet = drawSheet("long", {plainPiece("front", 200.0, 6000.0)}, 1400.0);
  const std::string text = pdfText(sheet, {wholePage(sheet)});
  CHECK(text.find("/UserUnit 2 ") != std::string::npos);
}
