#include "apps/page/verdict.h"

#include <fmt/format.h>

#include <cmath>

#include "garment/pattern/svg_file.h"

namespace ease {

namespace {

std::string sentence(const char* kind, const std::string& words) {
  return fmt::format("<p class=\"verdict {}\">{}</p>\n", kind, words);
}

std::string ofVerified(const Scene& scene, const Report& report) {
  const StretchStatistics &after = report.after.stretch.overall, &before = report.before.stretch.overall;
  const double target = fitsInPasses(scene) ? scene.adaption->fit.target : 0.0;
  const bool fits = after.share_over_limit <= target;
  std::string words =
      fmt::format("{} At the worst moment {} of the garment's triangles are stretched by more than {:.3g} %",
                  fits ? "The garment fits in every pose." : "Places of the garment stay too tight.",
                  percentText(after.share_over_limit), 100.0 * report.limit);
  if (after.taut_share_over_limit < after.share_over_limit)
    words += fmt::format(", {} of them taut and not crumpled",
                         percentText(after.taut_share_over_limit / after.share_over_limit));
  words += fmt::format("; before it was let out, {}.", percentText(before.share_over_limit));
  if (fitsInPasses(scene))
    words +=
        " These figures are the worse of the chosen pass and its check; pictures and tables below are of the check.";
  return sentence(fits ? "good" : "fair", words);
}

std::string ofUnverified(const Scene& scene, const Report& report) {
  const StretchStatistics& run = report.run.stretch.overall;
  if (!scene.adaption)
    return sentence("fair", fmt::format("The garment was simulated, not fitted: its largest stretch is {:.0f} %.",
                                        100.0 * (run.max - 1.0)));
  return sentence("fair", fmt::format("The garment was let out while the body moved, and not checked: on the way {} of "
                                      "its triangles were over the limit of {:.3g} % at the worst moment.",
                                      percentText(run.share_over_limit), 100.0 * report.limit));
}

}  // namespace

std::string percentText(double share) {
  return fmt::format("{:.3g}\u00a0%", std::round(1e4 * share) / 100.0);
}

std::string verdictHtml(const Scene& scene, const Report& report) {
  std::string html;
  if (!report.doubts.empty())
    html = sentence("bad", "The figures of this fit cannot be trusted: " + escaped(report.doubts.front()) + ".");
  else
    html = report.verified ? ofVerified(scene, report) : ofUnverified(scene, report);
  if (report.resumed_from_step)
    html += fmt::format(
        "<p>This command went on from step {} of a stopped run: pictures, charts and figures of the motion are those "
        "from there on.</p>\n",
        *report.resumed_from_step);
  if (report.fit.resumed_after > 0)
    html += fmt::format(
        "<p>This command went on after pass {} of a stopped fit: nothing is shown of the passes before.</p>\n",
        report.fit.resumed_after);
  html += "<dl class=\"figures\">";
  const auto figure = [&](const std::string& name, const std::string& value) {
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, value);
  };
  if (scene.adaption) {
    figure("cloth added", fmt::format("{:+.1f}\u00a0%", 100.0 * (report.growth.area_ratio - 1.0)));
    figure("most let out", fmt::format("×\u00a0{:.2f}", report.growth.max));
  }
  if (report.time_to_fit_s) figure("time to fit", fmt::format("{:.1f}\u00a0s", *report.time_to_fit_s));
  figure("triangles", fmt::format("{}", report.triangles));
  if (!report.fit.passes.empty()) figure("passes", fmt::format("{}", report.fit.passes.size()));
  return html + "</dl>\n";
}

}  // namespace ease
