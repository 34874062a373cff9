#include "apps/scene_pattern.h"

#include "tests/apps/scene_text.h"

using namespace ease;
using Catch::Contains;

namespace {

const std::string kCloth = "solver = {steps = 1}\ngarment = {mesh = 'cloth.obj'}\n";

}  // namespace

TEST_CASE("a scene without [pattern] has the defaults of one") {
  const PatternScene pattern = sceneOf(kCloth).pattern;
  CHECK(pattern.limits.thread == 0.05);
  CHECK(pattern.limits.shear == Approx(14.0 * M_PI / 180.0));
  CHECK(pattern.allowances.all == 0.010);
  CHECK(pattern.max_darts > 0);
  CHECK(pattern.check);
  CHECK_FALSE(pattern.free_grain);
}

TEST_CASE("the keys of [pattern] are read") {
  const PatternScene pattern =
      sceneOf(kCloth +
              "[pattern]\nthread_limit = 0.03\nshear_limit = 10\nshare = 0.9\ndarts = 2\nfabric_width = 0.9\n"
              "paper = 'letter'\ngrain = 'free'\nformats = ['svg']\ncheck = false\n"
              "[pattern.allowance]\ndefault = 0.012\nhem = 0.03\n[[pattern.piece]]\nname = 'front'\nat = [0, 1, 0.1]\n")
          .pattern;
  CHECK(pattern.limits.thread == 0.03);
  CHECK(pattern.limits.shear == Approx(10.0 * M_PI / 180.0));
  CHECK(pattern.limits.share == 0.9);
  CHECK(pattern.max_darts == 2);
  CHECK(pattern.fabric_width == 0.9);
  CHECK(pattern.free_grain);
  CHECK(paperNamed(pattern.paper).width == Approx(215.9));
  CHECK(pattern.formats == std::vector<std::string>{"svg"});
  CHECK_FALSE(pattern.check);
  CHECK(sceneOf(kCloth + "[pattern]\nlet_out = 1\n").pattern.let_out == 1);
  CHECK(pattern.allowances.all == 0.012);
  CHECK(pattern.allowances.by_name.at("hem") == 0.03);
  REQUIRE(pattern.names.size() == 1);
  CHECK(pattern.names[0].at == Vec3(0, 1, 0.1));
  CHECK(sceneOf(kCloth + "[pattern]\ndarts = false\nallowance = 0.02\n").pattern.max_darts == 0);
}

TEST_CASE("the keys of [pattern.cuts] are read, and are absent without the table") {
  CHECK_FALSE(sceneOf(kCloth).pattern.cuts);
  const CutsScene defaults = *sceneOf(kCloth + "[pattern.cuts]\n").pattern.cuts;
  CHECK(defaults.finds);
  CHECK(defaults.settings.flow.weights.distortion == 10.0);
  CHECK(defaults.settings.flow.weights.length == 5.0);
  CHECK(defaults.settings.flow.steps == 500);
  CHECK(defaults.settings.keep);
  CHECK(defaults.settings.remove);
  CHECK_FALSE(defaults.settings.is_symmetric);
  const CutsScene cuts = *sceneOf(kCloth +
                                  "[pattern.cuts]\nmethod = 'variational'\ndistortion_weight = 3\nlength_weight = 2\n"
                                  "steps = 50\nkeep = false\nsymmetric = 0.01\nremove = false\nstraighten = false\n")
                              .pattern.cuts;
  CHECK(cuts.finds);
  CHECK_FALSE(sceneOf(kCloth + "[pattern.cuts]\nmethod = 'none'\n").pattern.cuts->finds);
  CHECK_THAT(errorOf(kCloth + "[pattern.cuts]\nmethod = 'none'\nkeep = false\n"), Contains("method = 'variational'"));
  CHECK(cuts.settings.flow.weights.distortion == 3.0);
  CHECK(cuts.settings.flow.weights.length == 2.0);
  CHECK(cuts.settings.flow.steps == 50);
  CHECK_FALSE(cuts.settings.keep);
  CHECK_FALSE(cuts.settings.remove);
  CHECK_FALSE(cuts.settings.straighten);
  CHECK(cuts.settings.is_symmetric);
  CHECK(cuts.settings.plane == 0.01);
  CHECK(sceneOf(kCloth + "[pattern.cuts]\nsymmetric = true\n").pattern.cuts->settings.is_symmetric);
  CHECK_THAT(errorOf(kCloth + "[pattern.cuts]\nmethod = 'tailor'\n"), Contains("variational"));
  CHECK_THAT(errorOf(kCloth + "[pattern.cuts]\nlength_weight = 0\n"), Contains("length_weight"));
  CHECK_THAT(errorOf(kCloth + "[pattern.cuts]\nsymmetric = 'yes'\n"), Contains("symmetric"));
  CHECK_THAT(errorOf(kCloth + "[pattern.cuts]\nstep = 5\n"), Contains("did you mean 'steps'?"));
}

TEST_CASE("wrong keys of [pattern] are refused with what was expected") {
  CHECK_THAT(errorOf(kCloth + "[pattern]\ndarts = 'no'\n"), Contains("true, false, or how many at most"));
  CHECK_THAT(errorOf(kCloth + "[pattern]\ngrain = 'bias'\n"), Contains("free"));
  CHECK_THAT(errorOf(kCloth + "[pattern]\nfabric_width = 0.11\nallowance = 0.05\n"), Contains("at least 0.14 m"));
  CHECK_THAT(errorOf(kCloth + "[pattern]\ncheck = false\nlet_out = 2\n"), Contains("check = false"));
  CHECK_THAT(errorOf(kCloth + "[pattern]\ndart = true\n"), Contains("did you mean 'darts'?"));
  CHECK_THAT(errorOf(kCloth + "[pattern]\nformats = ['svg', 'hpgl']\n"), Contains("'hpgl' is none of them"));
  CHECK_THAT(errorOf(kCloth + "[pattern]\nallowance = 0.5\n"), Contains("a number from 0 to 0.2 m"));
  CHECK_THAT(errorOf(kCloth + "[[pattern.piece]]\nname = 'front'\n"), Contains("a point on the piece"));
  const std::string front = "[[pattern.piece]]\nname = 'front'\nat = [0, 1, 0.1]\n";
  CHECK_THAT(errorOf(kCloth + front + front), Contains("a name that no other piece has"));
}
