#include "apps/studio/tool.h"

#include <catch2/catch.hpp>

#include "tests/studio/hands.h"

namespace ease {
namespace {

TEST_CASE("a waist is drawn by clicks in front and behind, moved, and a region makes cloth of it") {
  Hands hands(kSmallDraft);
  hands.take(PartKind::boundary);
  hands.click(hands.at({0.12, 1.0, 0.06}));
  hands.click(hands.at({0.0, 1.0, 0.12}));
  hands.click(hands.at({-0.12, 1.0, 0.06}));
  hands.look(180);
  hands.click(hands.at({-0.1, 1.0, -0.1}));
  hands.click(hands.at({0.1, 1.0, -0.1}));
  hands.tool->finish();
  hands.studio.finishWork();
  INFO(hands.studio.words());
  REQUIRE(hands.studio.scene().garment.tools);
  REQUIRE(hands.studio.scene().garment.tools->boundaries.front().points.size() == 5);
  CHECK(hands.studio.made()->loops.size() == 1);

  const std::string before = hands.studio.text();
  hands.look(0);
  hands.drag(hands.at(hands.studio.scene().garment.tools->boundaries.front().points[1]), hands.at({0.0, 1.06, 0.12}));
  hands.studio.finishWork();
  CHECK(hands.studio.scene().garment.tools->boundaries.front().points[1].y() > 1.03);
  hands.studio.undo();
  hands.studio.finishWork();
  CHECK(hands.studio.text() == before);

  Pointer between = hands.at({0.06, 1.0, 0.11});
  between.control = true;
  hands.click(between);
  hands.studio.finishWork();
  CHECK(hands.studio.scene().garment.tools->boundaries.front().points.size() == 6);
  hands.click(hands.at(hands.studio.scene().garment.tools->boundaries.front().points[1]));
  hands.tool->remove();
  hands.studio.finishWork();
  CHECK(hands.studio.scene().garment.tools->boundaries.front().points.size() == 5);
}

TEST_CASE("with Mirror on, a point that is moved moves on the other side too, and both sleeves are pulled out alike") {
  Hands hands(kSmallDraft);
  std::string text = hands.studio.text();
  const std::vector<Vec3> waist = {{0.13, 1.0, 0.0}, {0.0, 1.0, 0.12}, {-0.13, 1.0, 0.0}, {0.0, 1.0, -0.12}};
  const std::vector<Vec3> sleeve = {{0.3, 1.45, 0.0}, {0.3, 1.39, 0.05}, {0.3, 1.33, 0.0}, {0.3, 1.39, -0.05}};
  text = withBoundary(withBoundary(withBoundary(text, "waist", waist), "left", sleeve), "right", mirrored(sleeve));
  hands.studio.gesture(text, "loops");
  hands.studio.finishWork();
  const auto loops = [&] { return hands.studio.scene().garment.tools->boundaries; };
  REQUIRE(loops().size() == 3);
  CHECK(mirrorImageOf(hands.studio.scene(), 1) == 2);
  CHECK(mirrorImageOf(hands.studio.scene(), 0) == -1);

  hands.studio.settings.mirror = true;
  hands.take(PartKind::boundary);
  const Vec3 before = loops()[1].points[1];
  hands.drag(hands.at(before), hands.at({before.x() + 0.04, before.y(), before.z()}));
  hands.studio.finishWork();
  INFO(hands.studio.words());
  CHECK((loops()[1].points[1] - before).norm() > 0.02);
  CHECK((mirrored(loops()[1].points[1]) - loops()[2].points[1]).norm() < 1e-3);
}

TEST_CASE("clicks in another pose are taken to the first one") {
  Hands hands(kSmallDraft);
  hands.studio.goTo(1);
  const Stage& stage = hands.studio.stage;
  // A place on the left wrist in the first pose; where it is now; what a click there is taken for.
  const SurfacePlace wrist = nearestPlace({0.6, 1.39, 0.03}, stage.firstPose(), stage.bodyTriangles());
  const Vec3 now = placeOn(wrist, stage.body(), stage.bodyTriangles());
  const Vec3 first = placeOn(wrist, stage.firstPose(), stage.bodyTriangles());
  REQUIRE((now - first).norm() > 0.1);
  const Pointer pointer = hands.pixel(now);
  const auto hit = stage.hitBody(pointer.x, pointer.y);
  REQUIRE(hit);
  CHECK((hit->made - first).norm() < 0.03);
}

TEST_CASE("every tool edits the scene, and what it makes is what the scene says") {
  Hands hands(smallTop());
  Studio& studio = hands.studio;
  INFO(studio.words());
  REQUIRE(studio.stage.hasCloth());
  const auto last = [&] { return studio.scene().garment; };

  hands.take(PartKind::extension);
  const Pointer hem = hands.onLoop("hem");
  Pointer down = hem;
  down.y += 60;
  hands.drag(hem, down);
  studio.finishWork();
  INFO(studio.words());
  REQUIRE(last().tools->extensions.size() == 1);
  CHECK(last().tools->extensions.front().length > 0.05);
  const double lowest = studio.stage.cloth().col(1).minCoeff();
  CHECK(lowest == Approx(1.0 - last().tools->extensions.front().length).margin(0.03));

  hands.take(PartKind::paint);
  studio.settings.mirror = true;
  hands.drag(hands.onCloth({0.1, 1.25, 0.12}), hands.onCloth({0.1, 1.1, 0.12}));
  studio.finishWork();
  REQUIRE(last().paint.size() == 2);  // mirrored
  CHECK(last().paint.front().stroke.size() > 2);
  CHECK(last().paint.back().at.x() == Approx(-last().paint.front().at.x()));
  const std::vector<double>& scales = studio.made()->input.paint;
  CHECK(*std::max_element(scales.begin(), scales.end()) == Approx(studio.settings.scale).margin(1e-3));  // no products
  studio.settings.mirror = false;

  hands.take(PartKind::comfort);
  hands.drag(hands.onCloth({0.0, 1.2, 0.12}), hands.onCloth({0.05, 1.2, 0.12}));
  studio.finishWork();
  REQUIRE(last().comfort_regions.size() == 1);
  CHECK(studio.made()->input.offsets.end() !=
        std::find_if(studio.made()->input.offsets.begin(), studio.made()->input.offsets.end(),
                     [&](double offset) { return offset > 0.9 * studio.settings.offset; }));

  hands.take(PartKind::pin);
  hands.click(hands.onLoop("neck"));
  studio.finishWork();
  REQUIRE(last().pins.size() == 1);
  CHECK(std::get<std::string>(last().pins.front().what) == "neck");
  hands.click(hands.onLoop("neck"));
  studio.finishWork();
  CHECK(last().pins.empty());

  hands.take(PartKind::seam);
  hands.click(hands.onLoop("neck"));
  hands.click(hands.onCloth({0.0, 1.2, 0.13}));
  hands.click(hands.onLoop("hem"));
  studio.finishWork();
  INFO(studio.words());
  REQUIRE(last().tools->seams.size() == 1);
  CHECK(last().tools->seams.front().from == "neck");
  CHECK(last().tools->seams.front().to == "hem");
}

TEST_CASE("a click on a seam picks it, and Del removes it") {
  Hands hands(sewnTop());
  INFO(hands.studio.words());
  REQUIRE(hands.studio.stage.hasCloth());
  hands.take(PartKind::seam);
  hands.tool->remove();
  CHECK(hands.studio.isRefusal());
  hands.look(90);
  hands.click(hands.onSeam(0));
  const std::optional<Part> picked = hands.tool->takePicked();
  REQUIRE(picked);
  CHECK(picked->label == "left side");
  CHECK_FALSE(hands.tool->takePicked());
  hands.tool->remove();
  hands.studio.finishWork();
  REQUIRE(hands.studio.scene().garment.tools->seams.size() == 3);
  CHECK(hands.studio.scene().garment.tools->seams.front().name == "right side");
}

TEST_CASE("nonsense is answered, and changes nothing") {
  Hands hands(kSmallDraft);
  Studio& studio = hands.studio;
  const std::string text = studio.text();
  const Pointer air{5.0, 5.0};
  const auto refused = [&] {
    const bool is_refusal = studio.isRefusal() && !studio.words().empty();
    studio.say("");
    return is_refusal && studio.text() == text;
  };
  for (int kind = 0; kind <= static_cast<int>(PartKind::seam); ++kind) {
    CAPTURE(kind);
    hands.take(static_cast<PartKind>(kind));
    hands.click(air);
    CHECK(refused());
  }
  hands.take(PartKind::boundary);
  hands.tool->finish();
  CHECK(refused());
  hands.tool->back();
  CHECK(refused());
  hands.tool->remove();
  CHECK(refused());
  hands.click(hands.at({0.0, 1.2, 0.12}));
  hands.tool->finish();  // one point is no loop
  CHECK(refused());
  hands.tool->cancel();
  hands.take(PartKind::region);
  hands.click(hands.at({0.0, 1.2, 0.12}));  // without boundaries
  CHECK(refused());
  studio.play(true);
  CHECK(refused());
  studio.undo();
  CHECK(refused());

  // A loop that goes there and back encloses nothing; one that crosses itself is refused by the tool that makes it.
  hands.take(PartKind::boundary);
  for (const Vec3& point : {Vec3(0.05, 1.2, 0.1), Vec3(-0.05, 1.1, 0.1), Vec3(-0.05, 1.2, 0.1), Vec3(0.05, 1.1, 0.1)})
    hands.click(hands.at(point));
  hands.tool->finish();
  studio.finishWork();
  INFO(studio.words());
  CHECK(refused());
}

TEST_CASE("a brush without radius, and gestures while the garment is made, are answered") {
  Hands hands(smallTop());
  Studio& studio = hands.studio;
  const std::string text = studio.text();
  hands.take(PartKind::paint);
  studio.settings.radius = 0.0;
  hands.click(hands.onCloth({0.0, 1.2, 0.12}));
  CHECK(studio.isRefusal());
  CHECK(studio.text() == text);
  studio.settings.radius = 0.1;
  REQUIRE(studio.gesture(withRegion(text, {0, 1.1, 0.12}), "region"));
  hands.click(hands.onCloth({0.0, 1.2, 0.12}));
  CHECK(studio.isRefusal());
  studio.finishWork();
  // A seed outside of the boundaries: the tool refuses, the scene is as before.
  const std::string good = studio.text();
  REQUIRE(studio.gesture(withRegion(good, {0, 1.65, 0.1}), "region"));
  studio.finishWork();
  CHECK(studio.isRefusal());
  CHECK(studio.text() == good);
}

}  // namespace
}  // namespace ease
