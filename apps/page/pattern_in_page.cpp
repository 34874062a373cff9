#include "apps/page/pattern_in_page.h"

#include <string>

#include "garment/pattern/svg_file.h"
#include "solver/base/whole_file.h"
#include "viz/jpeg.h"

namespace ease {

namespace {

std::string figureOf(const std::filesystem::path& picture, const std::string& caption) {
  const std::string bytes = contentOf(picture);
  if (bytes.empty()) return "";
  return "<figure><img src=\"" + dataUri(bytes, "image/png") + "\" alt=\"" + caption + "\"><figcaption>" + caption +
         "</figcaption></figure>\n";
}

}  // namespace

void showPatternInPage(const std::filesystem::path& directory, const std::string& summary,
                       const std::vector<std::string>& warnings) {
  const std::filesystem::path file = directory / "fit.html";
  const std::string page = contentOf(file);
  const size_t begins = page.find(kPatternBegins), ends = page.find(kPatternEnds);
  if (begins == std::string::npos || ends == std::string::npos || ends < begins) return;
  std::string section = kPatternBegins + std::string("\n<h2>Sewing pattern</h2>\n<ul>");
  for (const std::string& warning : warnings) section += "<li>" + escaped(warning) + "</li>\n";
  section += "</ul>\n<pre>" + escaped(summary) + "</pre>\n" +
             figureOf(directory / "pattern.png", "pieces, coloured by how far threads must stretch") +
             figureOf(directory / "pattern_resewn.png", "as designed and as sewn from the pieces, in the last pose");
  writeWholeFile(file, page.substr(0, begins) + section + page.substr(ends));
}

}  // namespace ease
