#include "apps/page/verdict.h"

#include <catch2/catch.hpp>

using namespace ease;
using Catch::Matchers::Contains;

namespace {

/// A fit in passes that ended with this share of its triangles over the limit.
std::pair<Scene, Report> fitted(double share, double taut) {
  Scene scene;
  scene.adaption.emplace();
  Report report;
  report.limit = 0.1;
  report.verified = true;
  report.after.stretch.overall.share_over_limit = share;
  report.after.stretch.overall.taut_share_over_limit = taut;
  report.before.stretch.overall.share_over_limit = 0.25;
  return {scene, report};
}

}  // namespace

TEST_CASE("a fit within its target fits, one beyond stays too tight and says how much of it is crumpled") {
  const auto [scene, fits] = fitted(0.0008, 0.0008);
  CHECK_THAT(verdictHtml(scene, fits),
             Contains("fits in every pose") && Contains("0.08\u00a0%") && !Contains("crumpled"));
  const auto [same, tight] = fitted(0.004, 0.001);
  CHECK_THAT(verdictHtml(same, tight), Contains("stay too tight") && Contains("25\u00a0% of them taut"));
}

TEST_CASE("a doubtful run is not to be trusted, a sequential one was not checked, a simulation was not fitted") {
  auto [scene, report] = fitted(0.0, 0.0);
  report.doubts = {"it fell"};
  CHECK_THAT(verdictHtml(scene, report), Contains("of this fit cannot be trusted: it fell"));
  report.doubts.clear();
  report.verified = false;
  report.run.stretch.overall.share_over_limit = 0.238;
  CHECK_THAT(verdictHtml(scene, report), Contains("not checked") && Contains("23.8\u00a0%"));
  scene.adaption.reset();
  CHECK_THAT(verdictHtml(scene, report), Contains("simulated, not fitted"));
  report.resumed_from_step = 80;
  CHECK_THAT(verdictHtml(scene, report), Contains("went on from step 80"));
}

TEST_CASE("a fit that went on says after which pass") {
  auto [scene, report] = fitted(0.0, 0.0);
  CHECK_THAT(verdictHtml(scene, report), !Contains("went on"));
  report.fit.resumed_after = 3;
  CHECK_THAT(verdictHtml(scene, report), Contains("went on after pass 3 of a stopped fit"));
}
