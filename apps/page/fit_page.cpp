#include "apps/page/fit_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "apps/page/fit_figures.h"
#include "apps/page/line_chart.h"
#include "apps/page/page_pictures.h"
#include "apps/page/page_style.h"
#include "apps/page/pattern_in_page.h"
#include "apps/page/verdict.h"
#include "apps/run_pictures.h"
#include "garment/pattern/svg_file.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace ease {

namespace {

constexpr double kFirm = 2000.0, kPainful = 5900.0, kPressureEnd = 10000.0;  // Pa
constexpr double kLooseEase = 0.05;                                          // m, end of the scale

class Writer {
 public:
  explicit Writer(const FitPage& page)
      : page_(page), limit_(shownLimit(page.scene)), areas_(garmentAreas(page.scene, page.input)) {
    for (size_t t = 0; t < page.rest_areas.size(); ++t) growth_.push_back(page.rest_areas[t] / page.first_areas[t]);
  }

  std::string html(PagePictures* pictures) {
    out_ = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\">\n<title>{0}: the "
        "fit</title>\n<style>{1}</style></head><body>\n"
        "<h1>{0}</h1>\n",
        escaped(page_.scene.name), kPageStyle);
    out_ += verdictHtml(page_.scene, page_.report);
    if (pictures) motion(*pictures);
    for (size_t p = 0; p < page_.input.pose_names.size(); ++p) {
      const int number = static_cast<int>(p);
      if (const ShownMoment* after = momentOfPose(page_.after, number))
        moment("Pose " + page_.input.pose_names[p], momentOfPose(page_.before, number), *after, pictures);
    }
    if (!page_.after.moments.empty() && page_.after.moments.back().pose < 0)
      moment("At the end", hasBefore() ? &page_.before.moments.back() : nullptr, page_.after.moments.back(), pictures);
    if (pictures && page_.scene.adaption) growth(*pictures);
    add("{}{}\n", kPatternBegins, kPatternEnds);
    tightest();
    charts();
    notes();
    madeWith();
    return out_ + fmt::format("<script>{}</script>\n</body></html>\n", kPageScript);
  }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    out_ += fmt::format(format, std::forward<Values>(values)...);
  }

  bool hasBefore() const { return !page_.before.moments.empty(); }

  void motion(PagePictures& pictures) {
    if (page_.after.moments.size() < 2) return;
    const std::vector<std::string> frames = pictures.drawFrames(page_.after, stretchScale());
    add("<h2>Through the motion</h2>\n<div class=\"motion\" id=\"motion\">\n");
    for (size_t m = 0; m < page_.after.moments.size(); ++m) {
      const ShownMoment& moment = page_.after.moments[m];
      const std::string pose = moment.pose >= 0 ? ", " + page_.input.pose_names[moment.pose] : "";
      add("<figure{}><img src=\"{}\" alt=\"garment at {:.2f} s\"><figcaption>{:.2f} s{}</figcaption></figure>\n",
          m == 0 ? " class=\"now\"" : "", frames[m], moment.time_s, moment.time_s, escaped(pose));
    }
    add("<input type=\"range\" min=\"0\" max=\"{}\" value=\"0\" aria-label=\"moment\"></div>\n",
        page_.after.moments.size() - 1);
    legend(stretch());
  }

  ColorScale stretchScale() const { return {1.0, 1.0 + 2.0 * limit_, 1.0 + limit_}; }
  ShownValue stretch() const {
    return {"Stretch", "%", 100.0, stretchScale(), {{1.0 + limit_, page_.scene.adaption ? "limit" : ""}}};
  }
  ShownValue pressure() const {
    return {
        "Pressure on the body", "kPa", 1e-3, {0.0, kPressureEnd, kPainful}, {{kFirm, "firm"}, {kPainful, "painful"}}};
  }
  ShownValue distance() const { return {"Ease: distance from the body", "mm", 1e3, {0.0, kLooseEase, kLooseEase}, {}}; }

  /// The colours of a value with its marks, as SVG.
  void legend(const ShownValue& value) {
    const double low = value.scale.low(), high = value.scale.high();
    const double zero = value.title == "Stretch" || value.title == "Growth" ? 1.0 : 0.0;  // shown as 0 %
    add("<svg class=\"legend\" viewBox=\"0 0 420 40\" role=\"img\" aria-label=\"colours of {}\">", value.title);
    constexpr int kBlocks = 60;
    for (int b = 0; b < kBlocks; ++b) {
      const Rgb c = value.scale.color(low + (high - low) * (b + 0.5) / kBlocks);
      add("<rect x=\"{}\" y=\"2\" width=\"7.3\" height=\"14\" fill=\"#{:02x}{:02x}{:02x}\"/>", 7 * b, c[0], c[1], c[2]);
    }
    const auto number = [&](double v, double x, const char* anchor, const std::string& word) {
      add("<text x=\"{:.0f}\" y=\"32\" text-anchor=\"{}\">{:.3g} {} {}</text>", x, anchor, value.factor * (v - zero),
          value.unit, word);
    };
    number(low, 0, "start", "");
    for (const auto& [at, word] : value.marks) {
      const double x = 420.0 * (at - low) / (high - low);
      add("<path class=\"mark\" d=\"M{0:.1f} 0V20\"/>", x);
      number(at, x, "middle", word);
    }
    number(high, 420, "end", "");
    add("</svg>\n");
    if (value.title != "Stretch" || !page_.scene.adaption) return;
    const Rgb grey = value.scale.color(std::numeric_limits<double>::quiet_NaN());
    add("<p class=\"crumpled\"><span style=\"background: #{:02x}{:02x}{:02x}\"></span> over the limit, but "
        "crumpled</p>\n",
        grey[0], grey[1], grey[2]);
  }

  /// Rows of pictures, each value under its title and its colours.
  void show(PagePictures& pictures, const std::vector<PictureRow>& rows) {
    const std::vector<SidePictures> drawn = pictures.drawSides(rows);
    for (size_t r = 0; r < rows.size(); ++r) {
      if (r == 0 || rows[r].value.title != rows[r - 1].value.title) {
        add("<h3>{}</h3>", rows[r].value.title);
        legend(rows[r].value);
      }
      add("<h4>{}</h4><div class=\"sides\">", rows[r].title);
      for (size_t side = 0; side < kSides.size(); ++side)
        add("<figure><img src=\"{}\" alt=\"{}, {}\"><figcaption>{}</figcaption></figure>", drawn[r][side],
            rows[r].title, kSides[side], kSides[side]);
      add("</div>\n");
    }
  }

  void moment(const std::string& title, const ShownMoment* before, const ShownMoment& after, PagePictures* pictures) {
    const std::string when_shown = after.time_s > 0.0 ? fmt::format("{:.2f} s", after.time_s) : "before the first step";
    add("<h2>{}, {}</h2>\n", escaped(title), when_shown);
    table(before, after);
    if (!pictures) return;
    const char* when = hasBefore() ? "after" : "as simulated";
    std::vector<PictureRow> rows;
    if (before && before->time_s > 0.0) rows.push_back({"before", stretch(), before, &before->sigma_1});
    rows.push_back({when, stretch(), &after, &after.sigma_1});
    if (!after.pressure.empty()) rows.push_back({when, pressure(), &after, &after.pressure});
    if (!after.distance.empty()) rows.push_back({when, distance(), &after, &after.distance});
    show(*pictures, rows);
  }

  void table(const ShownMoment* before, const ShownMoment& after) {
    const auto figures = areaFigures(areas_, page_.input, after, page_.first_areas, growth_);
    std::vector<AreaFigures> earlier;
    if (before) earlier = areaFigures(areas_, page_.input, *before, page_.first_areas, growth_);
    add("<div class=\"wide\"><table><tr><th>part</th><th>cloth at first, cm²</th>{}{}<th>largest "
        "stretch</th>{}<th>largest "
        "pressure, kPa</th><th>ease, mean mm</th></tr>\n",
        page_.scene.adaption ? "<th>cloth added</th>" : "", before ? "<th>largest stretch before</th>" : "",
        page_.scene.adaption ? "<th>triangles over the limit</th>" : "");
    for (size_t a = 0; a < figures.size(); ++a) {
      const AreaFigures& f = figures[a];
      add("<tr><th>{}</th><td>{:.0f}</td>", a < areas_.names.size() ? escaped(areas_.names[a]) : "all",
          1e4 * f.cloth_m2);
      if (page_.scene.adaption) add("<td>{:+.1f}\u00a0%</td>", 100.0 * (f.cloth_growth - 1.0));
      if (before) add("<td>{:.1f}\u00a0%</td>", 100.0 * (earlier[a].max_stretch - 1.0));
      add("<td>{:.1f}\u00a0%</td>", 100.0 * (f.max_stretch - 1.0));
      if (page_.scene.adaption) add("<td>{}</td>", percentText(f.share_over_limit));
      out_ += after.pressure.empty() ? "<td>–</td>" : fmt::format("<td>{:.2f}</td>", 1e-3 * f.max_pressure_Pa);
      out_ += after.distance.empty() ? "<td>–</td>" : fmt::format("<td>{:.1f}</td>", 1e3 * f.mean_distance_m);
      add("</tr>\n");
    }
    add("</table></div>\n");
  }

  void growth(PagePictures& pictures) {
    const std::vector<float> values(growth_.begin(), growth_.end());
    const double most = std::max(1.2, std::ceil(10.0 * *std::max_element(values.begin(), values.end())) / 10.0);
    const ShownValue value{"Growth", "%", 100.0, {1.0, most, most}, {}};
    add("<h2>Where cloth was added</h2>\n<p>Area of the rest shape over that of the garment as it was.</p>");
    show(pictures, {{"after", value, &page_.after.moments.front(), &values}});
  }

  void tightest() {
    const std::vector<TightPlace> places = tightestPlaces(page_.after, page_.input, 5);
    if (places.empty()) return;
    add("<h2>Tightest places</h2>\n<ol>");
    for (const TightPlace& place : places)
      add("<li>{:.1f} % at {:.2f} s: {}</li>", 100.0 * (place.stretch - 1.0), place.time_s,
          escaped(placeInWords(areas_, page_.input, place.triangle)));
    add("</ol>\n");
  }

  void charts() {
    const auto line = [&](const char* name, const char* color, const MotionAlbum& album, const auto& value) {
      ChartLine result{name, color, {}};
      for (size_t k = 0; k < album.curve.size(); ++k)
        result.points.emplace_back(album.curve[k].time_s, value(album, k));
      return result;
    };
    const auto chart = [&](const std::string& title, const auto& value, std::optional<double> limit) {
      LineChart made{title, "time, s", {}, limit};
      if (!page_.before.curve.empty()) made.lines.push_back(line("before", "#c2571a", page_.before, value));
      made.lines.push_back(line(hasBefore() ? "after" : "run", "#2b6ca3", page_.after, value));
      out_ += toSvg(made);
    };
    using Album = const MotionAlbum&;
    add("<h2>Over time</h2>\n<div class=\"charts\">");
    chart(
        "largest stretch, %", [](Album a, size_t k) { return 100.0 * (a.curve[k].stretch.max - 1.0); },
        page_.scene.adaption ? std::optional(100.0 * limit_) : std::nullopt);
    if (page_.scene.adaption)
      chart(
          "triangles over the limit, %", [](Album a, size_t k) { return 100.0 * a.curve[k].stretch.share_over_limit; },
          std::nullopt);
    chart(
        "fastest vertex, m/s", [](Album a, size_t k) { return a.curve[k].fastest_m_s; }, std::nullopt);
    chart(
        "computing time, s", [](Album a, size_t k) { return a.wall_s[k]; }, std::nullopt);
    add("</div>\n");
  }

  void notes() {
    if (page_.report.warnings.empty()) return;
    add("<h2>Asks for attention</h2>\n<ul>");
    for (const std::string& warning : page_.report.warnings) add("<li>{}</li>", escaped(warning));
    add("</ul>\n");
  }

  void madeWith() {
    std::ifstream file(page_.scene.file);
    std::ostringstream text;
    text << file.rdbuf();
    add("<h2>How to read this</h2>\n<p>Stretch is the larger principal stretch of a triangle, 0 % at rest; grey "
        "triangles "
        "are crumpled: sheared over the limit while neither thread is stretched. Pressure is that of the body on the "
        "cloth; wearers call up to 2 kPa comfortable, and 5.9 to 9.8 kPa is where it hurts (Denton 1972, <cite>Fit, "
        "Stretch, and Comfort</cite>). Ease is the distance from the body; the table has its mean over the part's "
        "triangles. Tightest places leave crumpled triangles out.</p>\n");
    add("<h2>Made with</h2>\n<p>Ease {}, method {}, time step {:.4g} s, {} vertices, {:.1f} s until "
        "this page.</p>\n<details><summary>"
        "scene</summary><pre>{}</pre></details>\n",
        EASE_VERSION, nameOf(page_.scene.solver.method), page_.report.time_step_s, page_.report.vertices,
        page_.report.total_s, escaped(text.str()));
  }

  const FitPage& page_;
  const double limit_;
  const GarmentAreas areas_;
  std::vector<double> growth_;  // area of each triangle of the rest shape over that of the first
  std::string out_;
};

}  // namespace

void writeFitPage(const FitPage& page, const std::filesystem::path& directory) {
  std::optional<PagePictures> pictures;
  try {
    pictures.emplace(page.input);
  } catch (const ComputationError&) {  // the report has the reason: the other pictures lack, too
  }
  writeWholeFile(directory / "fit.html", Writer(page).html(pictures ? &*pictures : nullptr));
}

}  // namespace ease
