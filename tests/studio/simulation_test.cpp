#include "apps/studio/simulation.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>

#include "apps/studio/parts.h"
#include "solver/base/stopwatch.h"
#include "tests/studio/hands.h"

namespace ease {
namespace {

bool allFinite(const LiveFrame& frame) {
  for (const Stretch& stretch : frame.stretch)
    if (!std::isfinite(stretch.sigma_1)) return false;
  return frame.garment.allFinite() && frame.rest.allFinite();
}

double area(const LiveFrame& frame) {
  double sum = 0.0;
  for (const double ratio : frame.growth) sum += ratio;
  return sum / static_cast<double>(frame.growth.size());
}

TEST_CASE("counted steps repeat to the bit") {
  const auto run = [] {
    Hands hands(smallTop());
    hands.studio.step(6);
    hands.studio.finishWork();
    return hands.studio.frame()->garment;
  };
  const Positions first = run();
  CHECK(first == run());
}

TEST_CASE("paint is taken in between two steps, where the cloth is, and undo takes it out again") {
  Hands hands(smallTop());
  Studio& studio = hands.studio;
  studio.step(4);
  studio.finishWork();
  const long steps = studio.frame()->steps;
  const Positions before = studio.frame()->garment;
  REQUIRE(studio.gesture(withPaint(studio.text(), {{0, 1.2, 0.12}}, 0.15, 1.2), "paint"));
  studio.finishWork();
  CHECK(studio.frame()->steps == steps);
  CHECK(studio.frame()->garment == before);
  CHECK(area(*studio.frame()) > 1.01);
  studio.undo();
  studio.finishWork();
  CHECK(area(*studio.frame()) == Approx(1.0).margin(2e-3));
}

TEST_CASE("the body goes to another pose from where it is, and turns back half way") {
  Hands hands(smallTop());
  Studio& studio = hands.studio;
  studio.goTo(1);
  studio.step(8);
  studio.finishWork();
  CHECK(studio.frame()->way == Approx(0.5).margin(0.01));
  const Positions half = studio.frame()->body;
  CHECK((half - studio.stage.firstPose()).rowwise().norm().maxCoeff() > 0.05);
  studio.goTo(0);
  studio.finishWork();
  CHECK((studio.frame()->body - half).rowwise().norm().maxCoeff() < 1e-9);
  studio.step(20);
  studio.finishWork();
  CHECK(studio.frame()->way == 1.0);
  CHECK((studio.frame()->body - studio.stage.firstPose()).rowwise().norm().maxCoeff() < 1e-6);
}

TEST_CASE("the body goes through all poses, and back the way it came, until it is told to stay") {
  std::string scene = smallTop();
  const std::string two_poses = "[\"t\", \"a\"]";
  scene.replace(scene.find(two_poses), two_poses.size(), "[\"t\", \"a\", \"up\"]");
  Hands hands(scene);
  Studio& studio = hands.studio;
  studio.tour(true);
  CHECK(studio.isOnTour());
  CHECK(studio.simulation().plays());
  std::vector<int> poses = {0};  // that the body is on the way to, one after the other
  const auto start = std::chrono::steady_clock::now();
  while (poses.size() < 6 && secondsSince(start) < 120.0) {
    studio.simulation().wantFrame(false);
    studio.poll();
    if (studio.frame() && studio.frame()->pose != poses.back()) poses.push_back(studio.frame()->pose);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  CHECK(poses == std::vector<int>{0, 1, 2, 1, 0, 1});
  studio.tour(false);
  CHECK_FALSE(studio.isOnTour());
  studio.play(false);
}

TEST_CASE("a pose that is chosen before the first picture of the garment is reached") {
  Hands hands(smallTop());
  Studio& studio = hands.studio;
  studio.startOver();  // its picture is not taken yet
  studio.stage.removeCloth();
  studio.goTo(1);
  studio.step(18);
  studio.finishWork();
  CHECK(studio.frame()->pose == 1);
  CHECK(studio.frame()->way == Approx(1.0));
}

TEST_CASE("paint that was taken in while it runs counts once after a later change of the mesh") {
  const auto clothOf = [](Studio& studio) {
    studio.finishWork();
    const Positions& x = studio.frame()->rest;
    double sum = 0.0;
    for (const auto& t : studio.made()->input.garment.triangles.rowwise())
      sum += 0.5 * doubleAreaNormal(x.row(t[0]), x.row(t[1]), x.row(t[2])).norm();
    return sum;
  };
  Hands hands(smallTop());
  Studio& studio = hands.studio;
  REQUIRE(studio.gesture(withPaint(studio.text(), {{0, 1.2, 0}}, 0.5, 1.2), "paint"));
  studio.finishWork();
  CHECK(studio.frame()->let_out == 0.0);
  REQUIRE(studio.gesture(withExtension(studio.text(), -1, "hem", 0.15, 1.05), "extension"));
  const double carried = clothOf(studio);
  studio.startOver();
  CHECK(carried == Approx(clothOf(studio)).epsilon(0.02));
}

TEST_CASE("a tour needs a garment") {
  Hands hands(kSmallDraft);
  hands.studio.tour(true);
  CHECK(hands.studio.isRefusal());
  CHECK_FALSE(hands.studio.isOnTour());
}

TEST_CASE("a longer skirt is carried over to where the cloth is, another garment starts over") {
  Hands hands(smallTop());
  Studio& studio = hands.studio;
  studio.goTo(1);
  studio.step(18);
  studio.finishWork();
  const double sleeve = studio.frame()->garment.col(0).maxCoeff();
  REQUIRE(studio.gesture(withExtension(studio.text(), -1, "hem", 0.15, 1.05), "extension"));
  studio.finishWork();
  INFO(studio.words());
  CHECK(studio.words().find("it keeps place and motion") != std::string::npos);
  CHECK(studio.frame()->steps == 18);
  CHECK(studio.frame()->garment.col(1).minCoeff() < 0.9);
  CHECK(studio.frame()->garment.col(0).maxCoeff() == Approx(sleeve).margin(0.03));  // the arms are still down
  studio.step(4);
  studio.finishWork();
  CHECK(allFinite(*studio.frame()));
}

TEST_CASE("material, limit, comfort and pins change while it runs") {
  Hands hands(smallTop());
  Studio& studio = hands.studio;
  studio.step(3);
  studio.finishWork();
  const auto edited = [&](const char* path, const char* key, const char* value) {
    SceneText text(studio.text());
    text.setValue(path, 0, key, value);
    return text.text();
  };
  for (const std::string& text :
       {edited("material", "density", "0.3"), edited("adaption", "limit", "0.05"),
        withPinnedLoop(studio.text(), "neck"), withComfort(studio.text(), {{0, 1.2, 0.12}}, 0.1, 0.05)}) {
    const long steps = studio.simulation().stepsMade();
    REQUIRE(studio.gesture(text, "change"));
    studio.finishWork();
    CHECK_FALSE(studio.isRefusal());
    studio.step(3);
    studio.finishWork();
    CHECK(studio.simulation().stepsMade() == steps + 3);
    CHECK(allFinite(*studio.frame()));
  }
}

TEST_CASE("a tight garment is let out while it runs, if that is asked for") {
  Hands hands(smallTop());
  Studio& studio = hands.studio;
  REQUIRE(studio.gesture(withPaint(studio.text(), {{0, 1.2, 0}}, 0.5, 0.8), "paint"));
  studio.finishWork();
  studio.setAdapting(false);
  studio.startOver();
  studio.step(16);
  studio.finishWork();
  CHECK(studio.frame()->let_out == 0.0);
  CHECK(area(*studio.frame()) == Approx(1.0).margin(1e-9));
  studio.setAdapting(true);
  studio.step(16);
  studio.finishWork();
  CHECK(studio.frame()->let_out > 0.0);
  CHECK(area(*studio.frame()) > 1.001);
}

/// Rounds of the test of random changes: 60, or as many as EASE_STUDIO_CHANGES says.
int rounds() {
  const char* wanted = std::getenv("EASE_STUDIO_CHANGES");
  return wanted ? std::atoi(wanted) : 60;
}

TEST_CASE("changes at random steps leave everything finite and stop nothing") {
  Hands hands(smallTop());
  Studio& studio = hands.studio;
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
  const auto change = [&](int kind) {
    const std::string& text = studio.text();
    const Vec3 place(uniform(-0.2, 0.2), uniform(1.0, 1.4), uniform(-0.1, 0.12));
    SceneText edited(text);
    switch (kind) {
      case 0:
        return (void)studio.gesture(withPaint(text, {place}, uniform(0.05, 0.3), uniform(0.85, 1.2)), "paint");
      case 1:
        return (void)studio.gesture(withComfort(text, {place}, uniform(0.05, 0.3), uniform(0.0, 0.04)), "comfort");
      case 2:
        return (void)studio.gesture(withPinnedBall(text, place, uniform(0.02, 0.1)), "pin");
      case 3:
        edited.setValue("material", 0, "density", tomlNumber(uniform(0.05, 0.5)));
        return (void)studio.gesture(edited.text(), "weight");
      case 4:
        edited.setValue("adaption", 0, "limit", tomlNumber(uniform(0.02, 0.2)));
        return (void)studio.gesture(edited.text(), "limit");
      case 5:
        return (void)studio.gesture(withExtension(text, studio.scene().garment.tools->extensions.empty() ? -1 : 0,
                                                  "hem", uniform(0.05, 0.3), uniform(0.9, 1.3)),
                                    "extension");
      case 6:
        return studio.goTo(static_cast<int>(uniform(0, 1.999)));
      case 7:
        return studio.undo();
      case 8:
        return studio.redo();
      default:
        return studio.setAdapting(uniform(0, 1) < 0.5);
    }
  };
  studio.play(true);
  for (int round = 0; round < rounds(); ++round) {
    change(static_cast<int>(uniform(0, 9.999)));
    if (round % 3 == 0) {
      while (studio.isMaking()) studio.poll();
    }
    studio.poll();
    INFO("round " << round << ": " << studio.words());
    CHECK(studio.words().compare(0, 8, "stopped:") != 0);
    if (studio.frame()) CHECK(allFinite(*studio.frame()));
    studio.play(true);
  }
  studio.play(false);
  studio.finishWork();
  CHECK(allFinite(*studio.frame()));
}

}  // namespace
}  // namespace ease
