#include "garment/pattern/paper_tiles.h"

#include <catch2/catch.hpp>

#include <regex>

#include "tests/garment/pattern/programs.h"

using namespace ease;

TEST_CASE("tiles of paper leave out what is empty, and each has its name and a box of 5 cm") {
  // 600 mm of cloth with pieces at its lower left and upper right corner only.
  Drawing sheet;
  sheet.width = 1000.0;
  sheet.height = 1400.0;
  sheet.pieces = {placed(plainPiece("one", 50.0, 50.0), false, {30.0, 30.0}),
                  placed(plainPiece("two", 50.0, 50.0), false, {900.0, 1300.0})};
  const std::vector<PdfPage> pages = paperTiles(sheet, Paper());
  CHECK(pages.size() >= 3);
  CHECK(pages.size() <= 5);
  const TemporaryFile file("tiles.pdf", pdfText(sheet, pages));
  if (!hasProgram("pdfinfo")) {
    WARN("pdfinfo is not installed");
    return;
  }
  CHECK(run("pdfinfo " + file.path()).output.find("595.276 x 841.89 pts (A4)") != std::string::npos);
}

TEST_CASE("a tile tells which pieces it shows, and what is glued to it only where there is a page") {
  Drawing sheet;
  sheet.width = 500.0;
  sheet.height = 300.0;
  sheet.pieces = {placed(plainPiece("one", 50.0, 50.0), false, {30.0, 100.0}),
                  placed(plainPiece("two", 50.0, 50.0), false, {400.0, 100.0})};
  const std::vector<PdfPage> pages = paperTiles(sheet, Paper());
  const auto says = [&](size_t page, const std::string& words) {
    return std::any_of(pages[page].texts.begin(), pages[page].texts.end(),
                       [&](const DrawnText& text) { return text.words.find(words) != std::string::npos; });
  };
  REQUIRE(pages.size() == 3);  // the cover, A1 and A3
  CHECK(says(1, "A1, page 2 of 3: one"));
  CHECK(says(2, "A3, page 3 of 3: two"));
  CHECK_FALSE(says(1, "glue"));
}

TEST_CASE("pages are cut on the sides that have no strip, and strips say what is glued there") {
  Drawing sheet;
  sheet.width = 400.0;
  sheet.height = 600.0;
  sheet.notes = {"allowances are drawn: 10 mm"};
  sheet.pieces = {placed(plainPiece("one", 360.0, 560.0), false, {20.0, 20.0})};
  const Paper paper;
  const std::vector<PdfPage> pages = paperTiles(sheet, paper);
  const auto find = [&](size_t page, const std::string& words) {
    const auto text = std::find_if(pages[page].texts.begin(), pages[page].texts.end(),
                                   [&](const DrawnText& t) { return t.words.find(words) != std::string::npos; });
    REQUIRE(text != pages[page].texts.end());
    return text->at;
  };
  find(0, "cut each page along its left and upper line");
  find(0, "allowances are drawn: 10 mm");
  CHECK(find(1, "glue A2 here").x() > paper.width - 20.0);  // page A1: its right strip
  CHECK(find(1, "glue B1 here").y() < 20.0);                // and its lower one
}

TEST_CASE("what lies at a place of the drawing is printed at one place of one tile, at its true size") {
  Drawing sheet;
  sheet.width = 400.0;
  sheet.height = 600.0;
  sheet.pieces = {placed(plainPiece("one", 360.0, 560.0), false, {20.0, 20.0})};
  const std::vector<PdfPage> pages = paperTiles(sheet, Paper());
  const PaperPoint at(200.0, 300.0);
  int shown = 0;
  for (size_t i = 1; i < pages.size(); ++i) {
    const PdfPage::View& view = pages[i].views.front();
    CHECK(view.scale == 1.0);
    const PaperPoint on_page = at + view.at;
    const PaperPoint inner_lower = view.lower + PaperPoint(0.0, 10.0), inner_upper = view.upper - PaperPoint(10.0, 0.0);
    if ((on_page.array() > inner_lower.array()).all() && (on_page.array() <= inner_upper.array()).all()) ++shown;
  }
  CHECK(shown == 1);
}

TEST_CASE("the test box measures 50 mm in the file as another program reads it") {
  if (!hasProgram("pdftocairo")) {
    WARN("pdftocairo is not installed");
    return;
  }
  const Drawing sheet = drawSheet("box", {plainPiece("front", 300.0, 300.0)}, 1400.0);
  const TemporaryFile file("box.pdf", pdfText(sheet, paperTiles(sheet, Paper())));
  const std::string svg = file.path() + ".svg";
  REQUIRE(run("pdftocairo -svg -f 1 -l 1 " + file.path() + " " + svg).code == 0);
  std::ifstream in(svg);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  std::filesystem::remove(svg);
  // Paths as "M x y L x y ..." under transform="matrix(a,b,c,d,e,f)": any horizontal side of 50 mm will do.
  const std::regex path(
      "d=\"M ([-0-9.]+) ([-0-9.]+) L ([-0-9.]+) ([-0-9.]+)[^\"]*\"[^>]*transform=\"matrix\\(([-0-9.]+)");
  bool is_found = false;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), path); it != std::sregex_iterator(); ++it) {
    const double length = std::abs(std::stod((*it)[3]) - std::stod((*it)[1])) * std::stod((*it)[5]);
    const double mm = length * 25.4 / 72.0;
    is_found |= std::abs(mm - 50.0) < 0.1;
  }
  CHECK(is_found);
}

TEST_CASE("the plan of all pages lies on the cover") {
  Drawing sheet;
  sheet.width = 1400.0;
  sheet.height = 700.0;
  sheet.pieces = {placed(plainPiece("wide", 1390.0, 690.0), false, {5.0, 5.0})};
  const Paper paper;
  const std::vector<PdfPage> pages = paperTiles(sheet, paper);
  for (const DrawnLine& line : pages.front().lines)
    for (const PaperPoint& p : line.points) {
      CHECK(p.minCoeff() >= 0.0);
      CHECK(p.x() <= paper.width);
      CHECK(p.y() <= paper.height);
    }
}
