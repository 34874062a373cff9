#include "apps/page/motion_album.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/sheet.h"

using namespace ease;

namespace {

/// A sheet of which one triangle is over the limit and one crumpled, and a watch that fills an album.
struct Filled {
  SceneInput given;
  InputNumbering numbering;
  RunWatch watch;
  MotionAlbum album;

  explicit Filled(bool poses_only) {
    given.garment = makeSheet(3, 3, 0.3, 0.3);
    given.offsets.assign(given.garment.positions.rows(), 0.005);
    numbering = spatialNumbering(given);
    fillAlbum(watch, given, numbering, 0.1, poses_only, album);
  }

  void tell(int pose, bool last) {
    const SceneInput input = renumbered(given, numbering);
    const Cloth cloth(input.garment, Vec3::UnitY(), Material());
    const State state{input.garment.positions, Positions::Zero(input.garment.positions.rows(), 3)};
    Moment moment;
    moment.pose = pose;
    moment.last = last;
    moment.time_s = 0.25;
    std::vector<Stretch> stretch(cloth.triangleCount(), Stretch{1.0, 1.0, 1.0, 1.0, {1.0, 0.0}});
    for (int t = 0; t < cloth.triangleCount(); ++t) {
      if (numbering.garment.triangles[t] == 4) stretch[t] = {1.2, 1.0, 1.2, 1.0, {1.0, 0.0}};
      if (numbering.garment.triangles[t] == 7) stretch[t] = {1.2, 0.8, 1.0, 1.0, {1.0, 0.0}};
    }
    const std::vector<int> pinned;
    Snapshot shot{moment, cloth, state, stretch, pinned, {}, {}, {}};
    shot.gap.assign(cloth.vertexCount(), 0.01);
    shot.pressure.assign(cloth.vertexCount(), 50.0);
    watch.on_shown(shot);
  }
};

}  // namespace

TEST_CASE("an album has the garment in the numbering of its file, with what is over the limit and what is crumpled") {
  Filled filled(false);
  filled.tell(-1, false);
  REQUIRE(filled.album.moments.size() == 1);
  const ShownMoment& moment = filled.album.moments.front();
  CHECK(moment.garment == filled.given.garment.positions);
  CHECK(moment.time_s == 0.25);
  for (int t = 0; t < filled.given.garment.triangles.rows(); ++t) {
    CHECK(std::isnan(moment.sigma_1[t]) == (t == 7));
    CHECK(moment.over[t] == (t == 4 || t == 7 ? 1.0F : 0.0F));
  }
  CHECK(moment.distance.front() == Approx(0.015));
  CHECK(moment.pressure.front() == 50.0F);
}

TEST_CASE("an album of poses leaves out what lies between, and finds the last moment of a pose") {
  Filled filled(true);
  filled.tell(0, false);
  filled.tell(-1, false);
  filled.tell(0, false);
  filled.tell(-1, true);
  CHECK(filled.album.moments.size() == 3);
  CHECK(momentOfPose(filled.album, 0) == &filled.album.moments[1]);
  CHECK(momentOfPose(filled.album, 1) == nullptr);
}

TEST_CASE("an album's curve has a point for each measured moment") {
  Filled filled(true);
  filled.watch.on_measured({0.1, {}, 2.0});
  filled.watch.on_measured({0.2, {}, 3.0});
  REQUIRE(filled.album.curve.size() == 2);
  CHECK(filled.album.curve[1].fastest_m_s == 3.0);
  CHECK(filled.album.wall_s[0] <= filled.album.wall_s[1]);
}
